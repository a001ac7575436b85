// Back faces of thin bodies, which oppose the pressure, are left out of contact surfaces.
#include "core/hydro/intersect.h"
#include "core/hydro/kernel/surface_writer.h"

#include <gtest/gtest.h>

#include <cstring>

#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kCubeModulus = 5e4, kCubeHalf = 0.02,
                 kPlateSide = 0.01;  // modulus [Pa], half size of the soft cube, side of plates [m]

/// A soft body whose pressure grows by `stiffness` below its top, which is at height `top`.
struct Field {
  const char* name;
  HydroBodyPtr body;
  double stiffness, top;
};

Field make_field(const char* name, FaceRule faces) {
  const std::string_view word(name);
  Material material = soft_material(kCubeModulus);
  material.faces = faces;
  if (word == "half-space") {
    material.thickness = kCubeHalf;
    return {name, make_simple_body(ShapeType::plane, dvec3(0), material), kCubeModulus / kCubeHalf, 0};
  }
  if (word == "medial axis") {
    material.field = FieldKind::medial_axis;
    return {name, make_simple_body(ShapeType::box, dvec3(kCubeHalf), material), kCubeModulus / kCubeHalf, kCubeHalf};
  }
  if (word == "star") {
    material.field = FieldKind::star;
    return {name, make_mesh_body(make_box(dvec3(kCubeHalf)), material), kCubeModulus / kCubeHalf, kCubeHalf};
  }
  material.thickness = 0.002;
  if (word == "pad of a box")
    return {name, make_simple_body(ShapeType::box, dvec3(kCubeHalf), material), kCubeModulus / material.thickness,
            kCubeHalf};
  return {name, make_mesh_body(make_box(dvec3(kCubeHalf)), material), kCubeModulus / material.thickness, kCubeHalf};
}

std::vector<Field> all_fields(FaceRule faces = FaceRule::along_gradient) {
  std::vector<Field> fields;
  for (const char* name : {"half-space", "medial axis", "star", "pad of a box", "pad of a mesh"})
    fields.push_back(make_field(name, faces));
  return fields;
}

HydroBodyPtr make_plate(double thickness, const Material& material = {}) {
  return make_mesh_body(make_box({0.5 * kPlateSide, 0.5 * kPlateSide, 0.5 * thickness}), material);
}

/// Returns the pose of a plate that is turned by `angle` [rad] about the y axis. The middle of its lower face is
/// `depth` below `top`.
Pose plate_pose(double thickness, double depth, double top, double angle = 0) {
  Pose pose{glm::angleAxis(angle, dvec3(0, 1, 0)), dvec3(0)};
  pose.p = dvec3(0.001, 0.002, top - depth) + pose.rotate(dvec3(0, 0, 0.5 * thickness));
  return pose;
}

dvec3 force_on_field(const Field& field, const HydroBody& plate, const Pose& pose) {
  return touch(*field.body, plate, Pose{}, pose).wrench.force;
}

TEST(BackFaces, LetFlatPlatesFeelTheirDepth) {
  for (const Field& field : all_fields()) {
    for (const double thickness : {0.02, 0.002, 0.76e-3, 0.2e-3, 0.05e-3, 0.01e-3}) {
      for (const double depth : {0.2e-3, 1e-3, 3e-3}) {
        SCOPED_TRACE(testing::Message() << field.name << ", " << thickness << " m thick, " << depth << " m deep");
        const dvec3 force = force_on_field(field, *make_plate(thickness), plate_pose(thickness, depth, field.top));
        const double expected = field.stiffness * depth * kPlateSide * kPlateSide;
        EXPECT_NEAR(force.z, -expected, 1e-9 * expected);
        EXPECT_NEAR(force.x, 0, 1e-9 * expected);
      }
    }
  }
}

// The middle of the lower face is d below the skin. The lower face alone feels k d A along its normal; a thick plate,
// whose upper face is outside, displaces the volume A d / cos(angle).
TEST(BackFaces, LetTiltedPlatesFeelTheirDepth) {
  constexpr double depth = 2.6e-3, area = kPlateSide * kPlateSide;
  for (const Field& field : all_fields()) {
    for (const double degrees : {2.0, 10.0, 25.0}) {
      const double angle = degrees * kPi / 180, whole = field.stiffness * depth * area;
      for (const double thickness : {0.1e-3, 0.05e-3, 0.01e-3}) {
        SCOPED_TRACE(testing::Message() << field.name << ", " << thickness << " m thick, " << degrees << " degrees");
        const dvec3 force =
            force_on_field(field, *make_plate(thickness), plate_pose(thickness, depth, field.top, angle));
        EXPECT_NEAR(force.z, -whole * std::cos(angle), 0.02 * whole);
        EXPECT_NEAR(force.x, -whole * std::sin(angle), 0.02 * whole);
      }
      if (degrees > 12) continue;  // walls that are steeper count in part
      const dvec3 force = force_on_field(field, *make_plate(0.02), plate_pose(0.02, depth, field.top, angle));
      EXPECT_NEAR(force.z, -whole / std::cos(angle), 0.02 * whole);
      EXPECT_NEAR(force.x, 0, 0.02 * whole);
    }
  }
}

TEST(BackFaces, CountIfTheMaterialAsksForAllFaces) {
  constexpr double thickness = 0.2e-3, depth = 1e-3;
  for (const Field& field : all_fields(FaceRule::all)) {
    SCOPED_TRACE(field.name);
    const dvec3 force = force_on_field(field, *make_plate(thickness), plate_pose(thickness, depth, field.top));
    const double expected = field.stiffness * thickness * kPlateSide * kPlateSide;
    EXPECT_NEAR(force.z, -expected, 1e-6 * expected);
  }
}

TEST(BackFaces, AreListedAmongPolygonsThatWereLeftOut) {
  const Field field = make_field("star", FaceRule::along_gradient);
  const Contact c = touch(*field.body, *make_plate(0.2e-3), Pose{}, plate_pose(0.2e-3, 1e-3, field.top));
  const RejectedPolygons& rejected = c.surface.left_out(Rejection::back_face);
  EXPECT_NEAR(rejected.area, kPlateSide * kPlateSide, 1e-9 * kPlateSide * kPlateSide);
  EXPECT_NEAR(rejected.force, field.stiffness * 0.8e-3 * kPlateSide * kPlateSide, 1e-9);
  EXPECT_EQ(rejected.count, static_cast<int>(c.surface.filtered.size()));
  std::size_t corners = 0;
  for (const ContactPolygon& p : c.surface.polygons) {
    EXPECT_EQ(static_cast<std::size_t>(p.first), corners);
    corners += static_cast<std::size_t>(p.count);
  }
  EXPECT_EQ(c.surface.vertices.size(), corners);
  EXPECT_EQ(c.surface.pressure.size(), corners);
  EXPECT_NEAR(c.surface.max_pressure(), field.stiffness * 1e-3, 1e-9 * kCubeModulus);
}

// The series of two springs: p = d / (1/ka + 1/kb).
TEST(BackFaces, LetASoftPlateFeelItsDepthInASoftBody) {
  constexpr double thickness = 0.4e-3, depth = 1e-3;
  Material stiff = soft_material(1e7);
  stiff.field = FieldKind::medial_axis;
  const HydroBodyPtr plate =
      make_simple_body(ShapeType::box, {0.5 * kPlateSide, 0.5 * kPlateSide, 0.5 * thickness}, stiff);
  for (const Field& field : all_fields()) {
    SCOPED_TRACE(field.name);
    const double together = 1 / (1 / field.stiffness + 0.5 * thickness / stiff.modulus);
    const double expected = together * depth * kPlateSide * kPlateSide;
    const Pose pose = plate_pose(thickness, depth, field.top);
    EXPECT_NEAR(force_on_field(field, *plate, pose).z, -expected, 0.02 * expected);
    const Contact swapped = touch(*plate, *field.body, pose, Pose{});
    EXPECT_NEAR(swapped.wrench.force.z, expected, 0.02 * expected);
  }
}

bool have_equal_bits(const ContactSurface& a, const ContactSurface& b) {
  const auto equal = [](const auto& x, const auto& y) {
    return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
  };
  if (!equal(a.vertices, b.vertices) || !equal(a.pressure, b.pressure) || a.polygons.size() != b.polygons.size())
    return false;
  for (std::size_t i = 0; i < a.polygons.size(); ++i) {
    const ContactPolygon &p = a.polygons[i], &q = b.polygons[i];
    if (p.pressure != q.pressure || p.gradient != q.gradient || p.area != q.area || p.weight != 1) return false;
  }
  return true;
}

TEST(BackFaces, LeaveThickBodiesTheirBits) {
  const std::vector<HydroBodyPtr> bodies{
      make_simple_body(ShapeType::sphere, dvec3(0.008, 0, 0)), make_simple_body(ShapeType::capsule, {0.006, 0.01, 0}),
      make_simple_body(ShapeType::plane, dvec3(0)), make_simple_body(ShapeType::box, dvec3(0.008))};
  const std::vector<double> radius{0.008, 0.006, 0, 0.008};
  const std::vector<Field> ruled = all_fields(), free = all_fields(FaceRule::all);
  for (std::size_t f = 1; f < ruled.size(); ++f) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const double depth : {0.3e-3, 1e-3, 2.5e-3}) {
        SCOPED_TRACE(testing::Message() << ruled[f].name << ", body " << b << ", " << depth << " m deep");
        Pose pose{glm::angleAxis(b == 2 ? kPi : 0.1, dvec3(1, 0, 0)), {0.001, 0.002, ruled[f].top + radius[b] - depth}};
        EXPECT_TRUE(have_equal_bits(touch(*ruled[f].body, *bodies[b], Pose{}, pose).surface,
                                    touch(*free[f].body, *bodies[b], Pose{}, pose).surface));
      }
    }
  }
}

/// Returns the largest change of the force per 0.1 degrees while a body turns once about the y axis, as a fraction of
/// the largest force.
double largest_step(const Field& field, const HydroBody& body, double depth) {
  double step = 0, most = 0;
  dvec3 before(0);
  for (int i = 0; i <= 3600; ++i) {
    const Pose pose{glm::angleAxis(i * kPi / 1800, dvec3(0, 1, 0)), {0.001, 0.002, field.top - depth}};
    const dvec3 force = force_on_field(field, body, pose);
    if (i > 0) step = std::max(step, glm::distance(force, before));
    most = std::max(most, glm::length(force));
    before = force;
  }
  return step / most;
}

// A plate turns about its middle: each of its faces is near in one half of the turn.
TEST(BackFaces, FadeWhereAThinBodyTurns) {
  for (const char* name : {"half-space", "medial axis", "star", "pad of a mesh"}) {
    SCOPED_TRACE(name);
    EXPECT_LT(largest_step(make_field(name, FaceRule::along_gradient), *make_plate(0.2e-3), 1.5e-3), 0.01);
  }
}

/// Returns a ring about the y axis with two walls of `count` rectangles.
TriMesh make_ring(double outer, double inner, double half_width, int count) {
  std::vector<dvec3> corners;  // four of each section: outer left, outer right, inner right, inner left
  std::vector<ivec3> faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    for (const dvec2& at : {dvec2(outer, -half_width), {outer, half_width}, {inner, half_width}, {inner, -half_width}})
      corners.emplace_back(at.x * std::sin(angle), at.y, at.x * std::cos(angle));
    const int here = 4 * i, next = 4 * ((i + 1) % count);
    for (int k = 0; k < 4; ++k) {
      const int a = here + k, b = here + (k + 1) % 4, c = next + (k + 1) % 4, d = next + k;
      faces.emplace_back(a, d, c);
      faces.emplace_back(a, c, b);
    }
  }
  return TriMesh(corners, faces);
}

// A ring of 0.3 mm rolls on the skin, 1 mm deep: its inner wall is the back face.
TEST(BackFaces, FadeWhereARingRolls) {
  const HydroBodyPtr ring = make_mesh_body(make_ring(0.006, 0.0057, 0.006, 48));
  for (const char* name : {"half-space", "medial axis", "pad of a mesh"}) {
    SCOPED_TRACE(name);
    EXPECT_LT(largest_step(make_field(name, FaceRule::along_gradient), *ring, 1e-3 - 0.006), 0.01);
  }
}

TEST(BackFaces, HaveAFactorThatFallsSmoothly) {
  const dvec3 n(0, 0, 1);
  const auto at = [&](double degrees) {
    const double angle = degrees * kPi / 180;
    return front_weight(n, 3.0 * dvec3(std::sin(angle), 0, std::cos(angle)));
  };
  EXPECT_EQ(at(0), 1);
  EXPECT_EQ(at(102), 1);
  EXPECT_NEAR(at(112.5), 0.5, 0.02);  // Drake's limit
  EXPECT_EQ(at(123), 0);
  EXPECT_EQ(at(180), 0);
  EXPECT_EQ(front_weight(n, dvec3(0)), 1);
  for (double degrees = 90; degrees < 130; degrees += 0.1) {
    EXPECT_LE(at(degrees + 0.1), at(degrees));
    EXPECT_LT(at(degrees) - at(degrees + 0.1), 0.008);
  }
}

}  // namespace
}  // namespace taxel
