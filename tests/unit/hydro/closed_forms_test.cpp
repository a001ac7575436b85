// The contact kernel against closed forms (docs/theory.md, "Validation").
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/mesh/primitives.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

Material soft(double modulus, double thickness = 0) {
  Material m;
  m.modulus = modulus;
  m.thickness = thickness;
  return m;
}

struct Contact {
  ContactSurface surface;
  Wrench wrench;
};

Contact touch(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB) {
  Contact contact;
  IntersectWorkspace workspace;
  intersect(a, b, X_WA, X_WB, contact.surface, workspace);
  contact.wrench = pressure_wrench(contact.surface);
  return contact;
}

Pose at_height(double z) { return {dquat(1, 0, 0, 0), dvec3(0, 0, z)}; }

Shape box_of(const dvec3& half_size) { return {ShapeType::box, half_size, nullptr, 0}; }

// A1: soft sphere on a rigid plane at depth x: F = pi E x^2 (1 - 2x/(3R)), a^2 = 2Rx - x^2, p_max = E x/R.
TEST(ClosedForms, SoftSphereOnRigidPlaneInAllDirections) {
  constexpr double R = 0.05, x = 0.05 * R;
  const auto sphere = make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0}, soft(kModulus), "sphere");
  const auto plane = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, Material{}, "plane");
  ASSERT_LE(std::get<SoftBody>(sphere->geometry).field->report().tets, 2100);
  const double force = kPi * kModulus * x * x * (1 - 2 * x / (3 * R)), area = kPi * (2 * R * x - x * x);
  double worst = 0, mean = 0, area_mean = 0;
  constexpr int kDirections = 200;
  for (int i = 0; i < kDirections; ++i) {
    Pose pose = random_pose(7, i, 0);
    pose.p = dvec3(0, 0, R - x);
    const Contact c = touch(*sphere, *plane, pose, Pose{});
    const double error = glm::length(c.wrench.force) / force - 1;
    worst = std::max(worst, std::abs(error));
    mean += error / kDirections;
    area_mean += (c.surface.area() / area - 1) / kDirections;
    EXPECT_NEAR(c.surface.max_pressure(), kModulus * x / R, 0.2 * kModulus * x / R);
  }
  RecordProperty("worst", std::to_string(worst));
  std::printf("A1 mean %.5f worst %.5f area %.5f\n", mean, worst, area_mean);
  EXPECT_LT(worst, 0.03);
}

// A2: rigid sphere in a soft half-space, kappa = E/H: F = kappa pi x^2 (R - x/3), area 2 pi R x.
TEST(ClosedForms, RigidSphereInSoftHalfSpace) {
  constexpr double R = 0.05, x = 0.1 * R, H = 0.01, kappa = kModulus / H;
  const auto sphere = make_body({ShapeType::sphere, dvec3(R, 0, 0), nullptr, 0}, Material{}, "sphere");
  const auto plane = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, soft(kModulus, H), "pad");
  const double force = kappa * kPi * x * x * (R - x / 3);
  const Contact c = touch(*plane, *sphere, Pose{}, at_height(R - x));
  EXPECT_NEAR(c.wrench.force.z, -force, 0.03 * force);
  EXPECT_NEAR(c.surface.area(), 2 * kPi * R * x, 0.02 * 2 * kPi * R * x);
  EXPECT_NEAR(c.wrench.force.x, 0, 1e-2 * force);
  const Contact swapped = touch(*sphere, *plane, at_height(R - x), Pose{});
  EXPECT_NEAR(swapped.wrench.force.z, -c.wrench.force.z, 1e-10 * force);
}

// A3: any closed rigid polyhedron in one linear field: F = kappa V_submerged through the submerged centroid. Exact.
TEST(ClosedForms, SubmergedBoxFeelsItsVolume) {
  constexpr double H = 0.01, kappa = kModulus / H;
  const dvec3 half(0.01, 0.02, 0.03);
  const auto box = make_body(box_of(half), Material{}, "box");
  const auto plane = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, soft(kModulus, H), "pad");
  const Contact c = touch(*box, *plane, at_height(half.z - 0.004), Pose{});
  const double force = kappa * 4 * half.x * half.y * 0.004;
  EXPECT_NEAR(c.wrench.force.z, force, 1e-10 * force);
  EXPECT_NEAR(glm::length(c.wrench.torque), 0, 1e-10 * force * half.z);
}

}  // namespace
}  // namespace taxel
