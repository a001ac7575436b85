// Contact of bodies whose pressure follows a law, against quadrature (docs/theory/hydro.md, "Pressure laws").
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "core/hydro/contact_stiffness.h"
#include "core/hydro/kernel/law_match.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kLawModulus = 1e5;
const PressureLaw kStiff{LawKind::stiffening, 0.78, {}};
const PressureLaw kSoft{LawKind::stiffening, 0.3, {}};
const PressureLaw kTable{LawKind::table, 0, {{0.15, 0.12}, {0.35, 0.4}, {0.6, 0.9}, {1, 2.2}}};

struct Named {
  const char* name;
  PressureLaw law;
};
const Named kLaws[] = {{"stiff", kStiff}, {"soft", kSoft}, {"table", kTable}};

Material with_law(const PressureLaw& law, double thickness = 0, double modulus = kLawModulus) {
  Material material = soft_material(modulus, thickness);
  material.law = law;
  return material;
}

/// Returns the integral of f from 0 to end.
double integral(double end, const std::function<double(double)>& f) {
  constexpr int kParts = 20000;
  double sum = 0;
  for (int i = 0; i < kParts; ++i) sum += f(end * (i + 0.5) / kParts) * end / kParts;
  return sum;
}

// A1: on a plane at depth x a sphere has the strain 1 - sqrt(r^2 + (R - x)^2)/R at the distance r from the middle.
TEST(LawContact, A1HoldsForASoftSphereInAllDirections) {
  constexpr double R = 0.05;
  for (const auto& [name, law] : kLaws) {
    const auto sphere = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), with_law(law));
    const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
    for (const double part : {0.05, 0.2, 0.4}) {
      const double x = part * R, rim = std::sqrt(2 * R * x - x * x);
      const double exact = integral(
          rim, [&](double r) { return kLawModulus * law.pressure(1 - std::hypot(r, R - x) / R) * 2 * kPi * r; });
      double mean = 0, worst = 0;
      for (int i = 0; i < 50; ++i) {
        Pose pose = random_pose(7, i, 0);
        pose.p = dvec3(0, 0, R - x);
        const Contact c = touch(*sphere, *plane, pose, Pose{});
        const double error = pose.rotate(c.wrench.force).z / exact - 1;
        mean += error / 50;
        worst = std::max(worst, std::abs(error));
      }
      EXPECT_LT(std::abs(mean), 0.01) << name;
      EXPECT_LT(worst, 0.03) << name;
    }
  }
}

// A2: a rigid sphere in a half-space of thickness H.
TEST(LawContact, A2HoldsForARigidSphereInASoftHalfSpace) {
  constexpr double R = 0.02, H = 0.01;
  for (const auto& [name, law] : kLaws) {
    const auto space = make_simple_body(ShapeType::plane, dvec3(0), with_law(law, H));
    const auto ball = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), {}, 0.002);
    for (const double x : {0.0005, 0.002, 0.005, 0.008}) {
      const double exact = integral(std::sqrt(2 * R * x - x * x), [&](double r) {
        return kLawModulus * law.pressure((x - R + std::sqrt(R * R - r * r)) / H) * 2 * kPi * r;
      });
      double worst = 0;
      for (int i = 0; i < 20; ++i) {
        Pose pose = random_pose(3, i, 0);
        pose.p = dvec3(0.01 * i, 0, R - x);
        const Contact c = touch(*space, *ball, Pose{}, pose);
        worst = std::max(worst, std::abs(-c.wrench.force.z / exact - 1));
      }
      EXPECT_LT(worst, 0.01) << name << " at " << x;
    }
  }
}

// A3: the force on a closed rigid polyhedron is the integral of the gradient of the pressure over its volume: for a
// cube that is tilted about one axis, slices of its profile.
TEST(LawContact, A3HoldsForATiltedCube) {
  constexpr double kHalf = 0.02, H = 0.05;
  for (const auto& [name, law] : kLaws) {
    Material material = with_law(law, H);
    material.faces = FaceRule::all;
    const auto space = make_simple_body(ShapeType::plane, dvec3(0), material);
    const auto cube = make_mesh_body(make_box(dvec3(kHalf)), {});
    for (const double tilt : {0.2, 0.5, kPi / 4}) {
      const Pose pose{glm::angleAxis(tilt, dvec3(0, 1, 0)), dvec3(0.003, 0.001, -0.01)};
      // Width of the section of the square at height z above its middle.
      const auto width = [&](double z) {
        const double c = std::cos(tilt), s = std::sin(tilt);
        double low = -1e9, high = 1e9;
        // Points (t, z) of the section are in the square if |t c - z s| <= half and |t s + z c| <= half.
        low = std::max(low, (-kHalf + z * s) / c), high = std::min(high, (kHalf + z * s) / c);
        low = std::max(low, (-kHalf - z * c) / s), high = std::min(high, (kHalf - z * c) / s);
        return std::max(0.0, high - low);
      };
      const double exact = integral(H, [&](double depth) {
        return kLawModulus / H * law.gradient(depth / H) * 2 * kHalf * width(-depth - pose.p.z);
      });
      const Contact c = touch(*space, *cube, Pose{}, pose);
      EXPECT_NEAR(-c.wrench.force.z, exact, 2e-4 * exact) << name << " at " << tilt;
    }
  }
}

// A4: a soft box on a rigid plane at depth x: the strain on the plane is that of the nearest side or of the face.
TEST(LawContact, A4HoldsForASoftBox) {
  const dvec3 half(0.02, 0.03, 0.015);
  constexpr double H = 0.015;
  for (const auto& [name, law] : kLaws) {
    const auto box = make_simple_body(ShapeType::box, half, with_law(law));
    const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
    for (const double part : {0.1, 0.3, 0.55}) {
      const double x = part * H;
      // The area of the section at a distance of more than d from its rim is (L1 - 2d)(L2 - 2d).
      const double exact = integral(x, [&](double d) {
        return kLawModulus / H * law.gradient(d / H) * (2 * half.x - 2 * d) * (2 * half.y - 2 * d);
      });
      const Contact c = touch(*box, *plane, Pose{dquat(1, 0, 0, 0), dvec3(0.001, 0.002, half.z - x)}, Pose{});
      EXPECT_NEAR(c.wrench.force.z, exact, 2e-4 * exact) << name << " at " << part;
    }
  }
}

// A8: two stacked slabs have the pressure at which their depths add up to x.
TEST(LawContact, A8HoldsForStackedSlabs) {
  const double L = 0.2, H1 = 0.006, H2 = 0.01;
  for (const auto& [name, law] : kLaws) {
    for (const PressureLaw& other : {PressureLaw{}, kStiff, kTable}) {
      for (const double stiffer : {1.0, 3.0}) {
        const auto slab = make_mesh_body(make_box({L / 2, L / 2, 0.02}), with_law(law, H1));
        const auto space = make_simple_body(ShapeType::plane, dvec3(0), with_law(other, H2, stiffer * kLawModulus));
        const auto second = make_mesh_body(make_box({L / 2, L / 2, 0.02}), with_law(other, H2, stiffer * kLawModulus));
        for (const double x : {0.001, 0.003, 0.006}) {
          double low = 0, high = 1e9;
          for (int i = 0; i < 200; ++i) {
            const double p = 0.5 * (low + high);
            (H1 * law.strain(p / kLawModulus) + H2 * other.strain(p / (stiffer * kLawModulus)) < x ? low : high) = p;
          }
          const Contact on_space = touch(*slab, *space, Pose{dquat(1, 0, 0, 0), {0, 0, 0.02 - x}}, Pose{});
          const Contact on_slab = touch(*slab, *second, Pose{dquat(1, 0, 0, 0), {0, 0, 0.04 - x}}, Pose{});
          EXPECT_NEAR(on_space.surface.max_pressure(), low, 0.01 * low) << name << " at " << x;
          EXPECT_NEAR(on_slab.surface.max_pressure(), low, 0.01 * low) << name << " at " << x;
        }
      }
    }
  }
}

// The energy is the work that pressed the bodies together: of a slab the integral of the law; of a ball on a pad, with
// a linear or a soft partner, the integral of the force, to the order of the depth over the radius.
TEST(LawContact, HasTheEnergyOfTheWork) {
  const double L = 0.06, H = 0.006, x = 0.003;
  for (const auto& [name, law] : kLaws) {
    const auto space = make_simple_body(ShapeType::plane, dvec3(0), with_law(law, H));
    const auto rigid = make_mesh_body(make_box({L / 2, L / 2, 0.015}), {});
    const auto energy_at = [](const HydroBody& a, const HydroBody& b, double height) {
      const Pose X{dquat(1, 0, 0, 0), {0, 0, height}};
      const Contact c = touch(a, b, X, Pose{});
      return elastic_energy(c.surface, a, b, RigidTransform(X.inverse()));
    };
    const double one = L * L * H * kLawModulus * law.energy(x / H);
    EXPECT_NEAR(energy_at(*rigid, *space, 0.015 - x), one, 1e-3 * one) << name;

    const double R = 0.02;
    const auto ball = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), {}, 0.001);
    const auto pad = make_mesh_body(make_box({L / 2, L / 2, 0.02}), with_law(law, H));
    const auto linear = make_mesh_body(make_box({L / 2, L / 2, 0.02}), soft_material(2 * kLawModulus, H));
    for (const auto& [other, from] : {std::pair(ball, 0.02 + R), std::pair(linear, 0.04)}) {
      constexpr int kSteps = 60;
      double work = 0;
      for (int i = 0; i < kSteps; ++i) {
        const Pose X{dquat(1, 0, 0, 0), {0, 0, from - x * (i + 0.5) / kSteps}};
        work += touch(*other, *pad, X, Pose{}).wrench.force.z * x / kSteps;
      }
      EXPECT_NEAR(energy_at(*other, *pad, from - x), work, x / (2 * R) * work) << name;
    }
  }
}

// The stiffness is the derivative of the force.
TEST(LawContact, HasTheStiffnessOfDifferences) {
  const double L = 0.06, H = 0.006, R = 0.02, step = 1e-5;
  for (const auto& [name, law] : kLaws) {
    const auto pad = make_mesh_body(make_box({L / 2, L / 2, 0.02}), with_law(law, H));
    const auto rigid = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), {}, 0.001);
    const auto soft = make_mesh_body(make_box({L / 2, L / 2, 0.02}), with_law(kSoft, H, 2 * kLawModulus));
    for (const auto& [other, from] : {std::pair(rigid, 0.02 + R), std::pair(soft, 0.04)}) {
      for (const double x : {0.0007, 0.0022}) {
        const auto at_depth = [&](double depth) { return Pose{dquat(1, 0, 0, 0), {0, 0, from - depth}}; };
        const Contact c = touch(*other, *pad, at_depth(x), Pose{});
        const Matrix6 K = contact_stiffness(c.surface, *other, *pad, RigidTransform(at_depth(x).inverse()));
        const double slope = (touch(*other, *pad, at_depth(x + step), Pose{}).wrench.force.z -
                              touch(*other, *pad, at_depth(x - step), Pose{}).wrench.force.z) /
                             (2 * step);
        EXPECT_NEAR(K[2][2], slope, 0.06 * slope) << name << " at " << x;
      }
    }
  }
}

/// Returns the volume and the area of the boundary of a field.
std::pair<double, double> extent_of(const PressureField& field) {
  double volume = 0, area = 0;
  for (const Tet& t : field.tets()) {
    const auto x = [&](int i) { return field.vertices()[static_cast<std::size_t>(t.vertices[i % 4])]; };
    volume += glm::dot(glm::cross(x(1) - x(0), x(2) - x(0)), x(3) - x(0)) / 6;
    for (int i = 0; i < 4; ++i)
      if (t.neighbour[static_cast<std::size_t>(i)] < 0)
        area += 0.5 * glm::length(glm::cross(x(i + 2) - x(i + 1), x(i + 3) - x(i + 1)));
  }
  return {volume, area};
}

TEST(DividedField, FillsTheSameBodyWithoutGaps) {
  const Material soft = with_law(kStiff), linear = soft_material(2 * kLawModulus);
  for (const PressureFieldPtr& field :
       {make_pad_field(std::make_shared<TriMesh>(make_box(dvec3(0.02, 0.02, 0.006))), kLawModulus, 0.005),
        make_sphere_field(0.01, kLawModulus, 0.002), make_box_field(dvec3(0.01, 0.02, 0.03), kLawModulus)}) {
    const PressureLaw pieces = LawMatch(soft, linear).pieces();
    ASSERT_EQ(pieces.table.size(), 5U);
    const DividedField divided = divide_field(*field, pieces, kLawModulus);
    EXPECT_GT(divided.field->tets().size(), field->tets().size());
    EXPECT_EQ(divided.field->report().inverted, 0);
    const auto [volume, area] = extent_of(*field);
    const auto [volume_of_parts, area_of_parts] = extent_of(*divided.field);
    EXPECT_NEAR(volume_of_parts, volume, 1e-12 * volume);
    EXPECT_NEAR(area_of_parts, area, 1e-10 * area);
    ASSERT_EQ(divided.parents.size(), divided.field->tets().size());
    for (std::size_t t = 0; t < divided.parents.size(); ++t) {
      const Tet& part = divided.field->tets()[t];
      const Tet& whole = field->tets()[static_cast<std::size_t>(divided.parents[t])];
      dvec3 middle(0);
      for (int i = 0; i < 4; ++i) middle += divided.field->vertices()[static_cast<std::size_t>(part.vertices[i])] / 4.0;
      for (std::size_t i = 0; i < 4; ++i) EXPECT_GT(glm::dot(whole.normal[i], middle) + whole.offset[i], -1e-12);
    }
  }
}

}  // namespace
}  // namespace taxel
