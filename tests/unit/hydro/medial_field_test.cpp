#include "core/hydro/medial_field.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "fixtures/field_checks.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

/// Fills the shape once, with sound tets and E on the medial axis.
void expect_fills(const PressureField& field, double volume) {
  expect_sound(field);
  EXPECT_EQ(field.report().inverted, 0);
  EXPECT_EQ(field.report().zero_gradient, 0);
  EXPECT_NEAR(field_volume(field), volume, 1e-9 * volume);
  EXPECT_EQ(field.max_pressure(), kModulus);
}

TEST(MedialField, FillsEveryPrimitive) {
  for (const dvec3& half : {dvec3(1, 2, 3), dvec3(2, 1, 2), dvec3(1, 1, 3), dvec3(1)}) {
    const PressureFieldPtr box = make_box_field(0.01 * half, kModulus);
    expect_fills(*box, 8e-6 * half.x * half.y * half.z);
    EXPECT_NEAR(box->report().stiffness_cv, 0, 1e-6);
  }
  const double r = 0.01;
  expect_fills(*make_capsule_field(r, 0.02, kModulus, 0.002), kPi * r * r * (0.04 + 4.0 / 3 * r));
  expect_fills(*make_cylinder_field(r, 0.02, kModulus, 0.002), kPi * r * r * 0.04);
  expect_fills(*make_cylinder_field(r, r, kModulus, 0.002), kPi * r * r * 2 * r);
  expect_fills(*make_ellipsoid_field({0.01, 0.02, 0.03}, kModulus, 0.003), 4.0 / 3 * kPi * 6e-6);
}

Contact on_plane(const HydroBody& body, const dquat& q, double height) {
  return touch(body, *make_simple_body(ShapeType::plane, dvec3(0)), {q, dvec3(0, 0, height)}, Pose{});
}

// A4: soft box on a plane: F = (E/H)(x L1 L2 - x^2 (L1 + L2) + 4 x^3/3). Exact.
TEST(MedialField, A4SoftBoxOnAPlane) {
  const dvec3 half(0.02, 0.03, 0.01);
  constexpr double x = 0.004;
  const auto box = make_simple_body(ShapeType::box, half, soft_material(kModulus));
  const double L1 = 2 * half.x, L2 = 2 * half.y,
               force = kModulus / half.z * (x * L1 * L2 - x * x * (L1 + L2) + 4 * x * x * x / 3);
  const Contact c = on_plane(*box, dquat(1, 0, 0, 0), half.z - x);
  EXPECT_NEAR(c.wrench.force.z, force, 1e-10 * force);
  EXPECT_NEAR(c.surface.area(), L1 * L2, 1e-12);
  EXPECT_EQ(c.surface.at_core, 0);
}

// A5: soft cylinder standing: F = pi E (R^3 - (R - x)^3)/(3H).
TEST(MedialField, A5SoftCylinderStanding) {
  for (const double half : {0.02, 0.03}) {
    constexpr double R = 0.02, x = 0.002;
    const double force = kPi * kModulus * (R * R * R - std::pow(R - x, 3)) / (3 * R);
    const auto cylinder = make_simple_body(ShapeType::cylinder, {R, half, 0}, soft_material(kModulus));
    const double found = on_plane(*cylinder, dquat(1, 0, 0, 0), half - x).wrench.force.z;
    EXPECT_NEAR(found, force, 0.01 * force) << half;
  }
}

// A6: soft cylinder lying, per length, as the difference of two lengths:
// F = E (a - (h^2/R) asinh(a/h)), h = R - x, a = sqrt(R^2 - h^2).
TEST(MedialField, A6SoftCylinderLying) {
  constexpr double R = 0.02, x = 0.002, h = R - x;
  const double a = std::sqrt(R * R - h * h), force = kModulus * (a - h * h / R * std::asinh(a / h));
  const auto press = [&](double half) {
    const auto cylinder = make_simple_body(ShapeType::cylinder, {R, half, 0}, soft_material(kModulus));
    return glm::length(on_plane(*cylinder, glm::angleAxis(kPi / 2, dvec3(1, 0, 0)), h).wrench.force);
  };
  EXPECT_NEAR((press(0.06) - press(0.04)) / 0.04, force, 0.02 * force);
}

/// A capsule on its cap is a sphere: A1.
TEST(MedialField, SoftCapsuleStandingIsASphere) {
  constexpr double R = 0.02, x = 0.05 * R;
  const auto capsule = make_simple_body(ShapeType::capsule, {R, 0.03, 0}, soft_material(kModulus));
  const double force = kPi * kModulus * x * x * (1 - 2 * x / (3 * R));
  EXPECT_NEAR(on_plane(*capsule, dquat(1, 0, 0, 0), 0.03 + R - x).wrench.force.z, force, 0.04 * force);
}

/// Affine images: an ellipsoid's force on a plane across an axis is the sphere's, stretched: F = E pi a b (x/c)^2 c (1
/// - 2x/(3c))/c.
TEST(MedialField, SoftEllipsoidIsAStretchedSphere) {
  const dvec3 s(0.02, 0.03, 0.015);
  const double x = 0.1 * s.z, u = x / s.z;
  const auto body = make_simple_body(ShapeType::ellipsoid, s, soft_material(kModulus), 0.002);
  const double force = kModulus * kPi * s.x * s.y * u * u * (1 - 2 * u / 3);
  EXPECT_NEAR(on_plane(*body, dquat(1, 0, 0, 0), s.z - x).wrench.force.z, force, 0.02 * force);
}

TEST(MedialField, BadInputIsRefused) {
  EXPECT_THROW(make_box_field(dvec3(1, 0, 1), 1), Error);
  EXPECT_THROW(make_box_field(dvec3(1), 0), Error);
  EXPECT_THROW(make_capsule_field(1, 1, 1, 0), Error);
  EXPECT_THROW(make_cylinder_field(2, 1, 1, 0.1), Error);
}

}  // namespace
}  // namespace taxel
