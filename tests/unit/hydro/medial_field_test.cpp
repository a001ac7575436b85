// Pressure fields of primitives: the depth relative to its largest value, without gaps.
#include "core/hydro/fields/pressure_field.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "fixtures/field_checks.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kPadModulus = 1e5;

/// Expects the field to fill the shape once, with valid tets and E on the medial axis.
void expect_fills(const PressureField& field, double volume) {
  expect_sound(field);
  EXPECT_EQ(field.report().inverted, 0);
  EXPECT_EQ(field.report().zero_gradient, 0);
  EXPECT_NEAR(field_volume(field), volume, 1e-9 * volume);
  EXPECT_EQ(field.max_pressure(), kPadModulus);
}

TEST(MedialField, FillsEveryPrimitive) {
  for (const dvec3& half : {dvec3(1, 2, 3), dvec3(2, 1, 2), dvec3(1, 1, 3), dvec3(1)}) {
    const PressureFieldPtr box = make_box_field(0.01 * half, kPadModulus);
    expect_fills(*box, 8e-6 * half.x * half.y * half.z);
    EXPECT_NEAR(box->report().stiffness_cv, 0, 1e-6);
  }
  const double r = 0.01;
  expect_fills(*make_capsule_field(r, 0.02, kPadModulus, 0.002), kPi * r * r * (0.04 + 4.0 / 3 * r));
  expect_fills(*make_cylinder_field(r, 0.02, kPadModulus, 0.002), kPi * r * r * 0.04);
  expect_fills(*make_cylinder_field(r, r, kPadModulus, 0.002), kPi * r * r * 2 * r);
  expect_fills(*make_cylinder_field(0.03, r, kPadModulus, 0.002), kPi * 9e-4 * 2 * r);
  expect_fills(*make_cylinder_field(0.0101, r, kPadModulus, 0.002), kPi * 0.0101 * 0.0101 * 2 * r);
  expect_fills(*make_ellipsoid_field({0.01, 0.02, 0.03}, kPadModulus, 0.003), 4.0 / 3 * kPi * 6e-6);
}

/// The flat cylinder's axis is a disc, and there must be no gap between the tets at its rim or inside it. Only faces of
/// the skin are open, so the number of open faces equals that of the skin.
TEST(MedialField, HasNoGaps) {
  const auto open_but_skin = [](const PressureField& field) {
    int count = 0;
    for (const Tet& tet : field.tets()) {
      for (int i = 0; i < 4; ++i) count += tet.neighbour[i] < 0 && !field.is_skin(tet, i) ? 1 : 0;
    }
    return count;
  };
  for (const dvec3& half : {dvec3(1, 2, 3), dvec3(2, 1, 2), dvec3(1, 1, 3), dvec3(1)})
    EXPECT_EQ(open_but_skin(*make_box_field(half, kPadModulus)), 0);
  for (const double edge : {0.004, 0.0031, 0.0023}) {
    EXPECT_EQ(open_but_skin(*make_cylinder_field(0.03, 0.01, kPadModulus, edge)), 0) << edge;
    EXPECT_EQ(open_but_skin(*make_cylinder_field(0.01, 0.03, kPadModulus, edge)), 0) << edge;
    EXPECT_EQ(open_but_skin(*make_capsule_field(0.01, 0.03, kPadModulus, edge)), 0) << edge;
  }
}

/// Returns the largest |p/E - depth/H| at random points that are both in the shape and in a tet.
template <class Depth>
double worst_error(const PressureField& field, double H, const Depth& depth) {
  const CounterRng rng(11);
  double worst = 0;
  int inside = 0;
  for (std::uint64_t i = 0; inside < 3000; ++i) {
    const Aabb& box = field.bounds();
    const dvec3 x = box.lo + box.extent() * dvec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2));
    for (const Tet& tet : field.tets()) {
      bool in = depth(x) > 0;
      for (std::size_t k = 0; k < 4; ++k) in = in && glm::dot(tet.normal[k], x) + tet.offset[k] > 0;
      if (!in) continue;
      ++inside;
      worst = std::max(worst, std::abs((glm::dot(tet.gradient, x) + tet.constant) / kPadModulus - depth(x) / H));
      break;
    }
  }
  return worst;
}

/// Exact for flat faces. For round shapes, the facets differ from the shape by about edge^2/(8 R).
TEST(MedialField, IsTheDepthOverItsLargestValue) {
  const dvec3 half(0.01, 0.02, 0.03);
  EXPECT_LT(worst_error(*make_box_field(half, kPadModulus), 0.01,
                        [&](const dvec3& x) {
                          const dvec3 d = half - glm::abs(x);
                          return std::min({d.x, d.y, d.z});
                        }),
            1e-12);
  const auto to_segment = [](const dvec3& x, double half_length) {
    return glm::distance(x, dvec3(0, 0, std::clamp(x.z, -half_length, half_length)));
  };
  for (const double edge : {0.004, 0.002}) {
    const double R = 0.01, bound = 0.3 * edge * edge / R / R;
    EXPECT_LT(
        worst_error(*make_sphere_field(R, kPadModulus, edge), R, [&](const dvec3& x) { return R - glm::length(x); }),
        bound);
    EXPECT_LT(worst_error(*make_capsule_field(R, 0.02, kPadModulus, edge), R,
                          [&](const dvec3& x) { return R - to_segment(x, 0.02); }),
              bound);
    const auto cylinder = [](double radius, double half_length) {
      return [=](const dvec3& x) { return std::min(radius - std::hypot(x.x, x.y), half_length - std::abs(x.z)); };
    };
    EXPECT_LT(worst_error(*make_cylinder_field(R, 0.02, kPadModulus, edge), R, cylinder(R, 0.02)), bound);
    EXPECT_LT(worst_error(*make_cylinder_field(0.03, R, kPadModulus, edge), R, cylinder(0.03, R)), bound);
    EXPECT_LT(worst_error(*make_ellipsoid_field(half, kPadModulus, edge), 1,
                          [&](const dvec3& x) { return 1 - glm::length(x / half); }),
              bound);
  }
}

Contact on_plane(const HydroBody& body, const dquat& q, double height) {
  return touch(body, *make_simple_body(ShapeType::plane, dvec3(0)), {q, dvec3(0, 0, height)}, Pose{});
}

// A4: soft box on a plane: F = (E/H)(x L1 L2 - x^2 (L1 + L2) + 4 x^3/3). Exact.
TEST(MedialField, A4HoldsForASoftBoxOnAPlane) {
  const dvec3 half(0.02, 0.03, 0.01);
  constexpr double x = 0.004;
  const auto box = make_simple_body(ShapeType::box, half, soft_material(kPadModulus));
  const double L1 = 2 * half.x, L2 = 2 * half.y,
               force = kPadModulus / half.z * (x * L1 * L2 - x * x * (L1 + L2) + 4 * x * x * x / 3);
  const Contact c = on_plane(*box, dquat(1, 0, 0, 0), half.z - x);
  EXPECT_NEAR(c.wrench.force.z, force, 1e-10 * force);
  EXPECT_NEAR(c.surface.area(), L1 * L2, 1e-12);
  EXPECT_EQ(c.surface.at_core(), 0);
}

// A5: soft upright cylinder: F = pi E (R^3 - (R - x)^3)/(3H).
TEST(MedialField, A5HoldsForASoftUprightCylinder) {
  for (const double half : {0.02, 0.03}) {
    constexpr double R = 0.02, x = 0.002;
    const double force = kPi * kPadModulus * (R * R * R - std::pow(R - x, 3)) / (3 * R);
    const auto cylinder = make_simple_body(ShapeType::cylinder, {R, half, 0}, soft_material(kPadModulus));
    const double found = on_plane(*cylinder, dquat(1, 0, 0, 0), half - x).wrench.force.z;
    EXPECT_NEAR(found, force, 0.01 * force) << half;
  }
}

// A6: soft lying cylinder, per length, as the difference of two lengths:
// F = E (a - (h^2/R) asinh(a/h)), h = R - x, a = sqrt(R^2 - h^2).
TEST(MedialField, A6HoldsForASoftLyingCylinder) {
  constexpr double R = 0.02, x = 0.002, h = R - x;
  const double a = std::sqrt(R * R - h * h), force = kPadModulus * (a - h * h / R * std::asinh(a / h));
  const auto press = [&](double half) {
    const auto cylinder = make_simple_body(ShapeType::cylinder, {R, half, 0}, soft_material(kPadModulus));
    return glm::length(on_plane(*cylinder, glm::angleAxis(kPi / 2, dvec3(1, 0, 0)), h).wrench.force);
  };
  EXPECT_NEAR((press(0.06) - press(0.04)) / 0.04, force, 0.02 * force);
}

/// A capsule on its cap is a sphere: A1.
TEST(MedialField, EqualsASphereForAnUprightSoftCapsule) {
  constexpr double R = 0.02, x = 0.05 * R;
  const auto capsule = make_simple_body(ShapeType::capsule, {R, 0.03, 0}, soft_material(kPadModulus));
  const double force = kPi * kPadModulus * x * x * (1 - 2 * x / (3 * R));
  EXPECT_NEAR(on_plane(*capsule, dquat(1, 0, 0, 0), 0.03 + R - x).wrench.force.z, force, 0.04 * force);
}

/// Affine images: an ellipsoid's force on a plane across an axis is the sphere's force, stretched:
/// F = E pi a b (x/c)^2 c (1 - 2x/(3c))/c.
TEST(MedialField, EqualsAStretchedSphereForASoftEllipsoid) {
  const dvec3 s(0.02, 0.03, 0.015);
  const double x = 0.1 * s.z, u = x / s.z;
  const auto body = make_simple_body(ShapeType::ellipsoid, s, soft_material(kPadModulus), 0.002);
  const double force = kPadModulus * kPi * s.x * s.y * u * u * (1 - 2 * u / 3);
  EXPECT_NEAR(on_plane(*body, dquat(1, 0, 0, 0), s.z - x).wrench.force.z, force, 0.02 * force);
}

TEST(MedialField, RefusesBadInput) {
  EXPECT_THROW(make_box_field(dvec3(1, 0, 1), 1), Error);
  EXPECT_THROW(make_box_field(dvec3(1), 0), Error);
  EXPECT_THROW(make_capsule_field(1, 1, 1, 0), Error);
  EXPECT_THROW(make_cylinder_field(0, 1, 1, 0.1), Error);
}

}  // namespace
}  // namespace taxel
