// Two soft bodies whose tets share planes with each other and with the contact surface: every part of the surface is
// counted exactly once.
#include <gtest/gtest.h>

#include "core/hydro/kernel/index/wide_tree.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

constexpr double kStiffness = 1e7;  // E/H [Pa/m]
constexpr double kThickness = 0.01;
const dvec2 kHalf(0.01, 0.015), kWide(0.04);

/// Returns an upside-down slab whose skin at z = 0 faces the other slab, with four layers of 2.5 mm.
HydroBodyPtr upper_slab() {
  return make_slab(kHalf, kThickness, {4, 6, 4}, kStiffness);
}
/// Returns a slab with its skin up, on a grid of 5 mm cells as in the upper slab.
HydroBodyPtr lower_slab(double stiffness = kStiffness) {
  return make_slab(kWide, kThickness, {16, 16, 4}, stiffness);
}

/// Returns the pose of the upper slab that is pressed `depth` into the lower one at a place and yaw. A rotation by pi
/// about x maps the plane z = 0 to itself.
Pose upper_pose(double depth, const dvec2& place, double yaw) {
  return {glm::angleAxis(yaw, dvec3(0, 0, 1)) * dquat(0, 1, 0, 0), dvec3(place, -depth)};
}

void expect_one_layer(const HydroBody& upper, const HydroBody& lower, const Pose& X_WU, const Pose& X_WL, double depth,
                      double tolerance = 1e-12) {
  const Contact c = touch(upper, lower, X_WU, X_WL);
  const double area = 4 * kHalf.x * kHalf.y, pressure = 0.5 * kStiffness * depth;  // A8 with equal slabs
  const RejectedPolygons& slivers = c.surface.left_out(Rejection::sliver);
  EXPECT_NEAR(c.surface.area() + slivers.area, area, tolerance * area);
  EXPECT_NEAR(glm::length(c.wrench.force) + slivers.force, pressure * area, tolerance * pressure * area);
  EXPECT_LT(slivers.area, 1e-10 * area);
}

struct Placing {
  const char* name;
  dvec2 place;
  double yaw;
};
const Placing kPlacings[] = {{"grids agree", dvec2(0), 0},
                             {"vertices on diagonals", dvec2(0.0025, 0.0025), 0},
                             {"vertices on edges", dvec2(0.0025, 0), 0},
                             {"a quarter turn", dvec2(0.005, 0), 0.5 * kPi},
                             {"edges along diagonals", dvec2(0), 0.25 * kPi},
                             {"anyhow", dvec2(0.00123, -0.00321), 0.4}};

// The equal-pressure plane is half the overlap deep in both slabs. An overlap of 5 mm puts this plane into planes of
// both grids.
TEST(Coplanar, CountsASurfaceInPlanesOfBothGridsOnce) {
  const HydroBodyPtr upper = upper_slab(), lower = lower_slab();
  for (const Placing& placing : kPlacings) {
    for (const double noise : {0.0, 1e-19, -1e-19, 1e-18, -1e-18, 1e-17, -1e-17, 1e-16, -1e-16}) {
      SCOPED_TRACE(testing::Message() << placing.name << ", noise " << noise);
      const double depth = 0.005 + noise;
      expect_one_layer(*upper, *lower, upper_pose(depth, placing.place, placing.yaw), Pose{}, depth);
      expect_one_layer(*lower, *upper, Pose{}, upper_pose(depth, placing.place, placing.yaw), depth);
    }
  }
}

// Near the planes, tets are clipped to very narrow strips. Strips up to 1e-12 of a tet's size may be counted with both
// neighbours.
TEST(Coplanar, CountsASurfaceNearThePlanesOfTheGridsOnce) {
  const HydroBodyPtr upper = upper_slab(), lower = lower_slab();
  int number = 0;
  for (const Placing& placing : kPlacings) {
    for (double beside = 1e-15; beside < 2e-6; beside *= std::sqrt(10.0)) {
      for (const double depth : {0.005 + beside, 0.005 - beside}) {
        SCOPED_TRACE(testing::Message() << placing.name << ", near " << depth - 0.005);
        const Pose motion = random_pose(33, ++number, 0.5);
        expect_one_layer(*upper, *lower, upper_pose(depth, placing.place, placing.yaw), Pose{}, depth, 1e-11);
        expect_one_layer(*upper, *lower, motion * upper_pose(depth, placing.place, placing.yaw), motion, depth, 1e-11);
      }
    }
  }
}

TEST(Coplanar, CountsASurfaceInPlanesOfOneGridOnce) {
  const HydroBodyPtr upper = upper_slab(), lower = make_slab(kWide, kThickness, {16, 16, 3}, kStiffness);
  for (const Placing& placing : kPlacings) {
    SCOPED_TRACE(placing.name);
    expect_one_layer(*upper, *lower, upper_pose(0.005, placing.place, placing.yaw), Pose{}, 0.005);
    expect_one_layer(*lower, *upper, Pose{}, upper_pose(0.005, placing.place, placing.yaw), 0.005);
  }
}

TEST(Coplanar, GivesTheSameResultInAnyFrame) {
  const HydroBodyPtr upper = upper_slab(), lower = lower_slab();
  for (int i = 0; i < 100; ++i) {
    const Placing& placing = kPlacings[i % 6];
    const Pose motion = random_pose(32, i, 0.5);
    SCOPED_TRACE(testing::Message() << placing.name << ", motion " << i);
    expect_one_layer(*upper, *lower, motion * upper_pose(0.005, placing.place, placing.yaw), motion, 0.005);
  }
}

}  // namespace
}  // namespace taxel
