// Two soft bodies pressed deeper than the tets of a pad: the equal-pressure surface continues without a hole.
#include "core/hydro/kernel/depth_march.h"

#include <gtest/gtest.h>

#include "core/hydro/contact_stiffness.h"
#include "fixtures/counted_new.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/instruction_sets.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kModulus = 5e4, kThickness = 0.002, kStiffness = kModulus / kThickness, kRadius = 0.015;

HydroBodyPtr spherical_pad() {
  return make_simple_body(ShapeType::sphere, dvec3(kRadius, 0, 0), soft_material(kModulus, kThickness), 0.002);
}

HydroBodyPtr finger() {
  return make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
}

int pieces_of(const ContactSurface& surface) {
  return static_cast<int>(std::count_if(surface.polygons.begin(), surface.polygons.end(),
                                        [](const ContactPolygon& p) { return p.tet < 0; }));
}

/// Returns the pose of two fingers, tip to side, `depth` into each other.
Pose side_on_tip(double depth) {
  Pose X{glm::normalize(dquat(0.7, 0.7, 0.1, 0)), dvec3(0.001, 0, 0)};
  double lowest = std::numeric_limits<double>::infinity();
  const TriMesh tip = make_fingertip();
  for (const dvec3& v : tip.vertices()) lowest = std::min(lowest, X.rotate(v).z);
  X.p.z = tip.bounds().hi.z - lowest - depth;
  return X;
}

/// Equal spheres meet in the plane of symmetry, each x deep: F = (E/H) pi (R x^2 - 2/3 x^3), as on a rigid plane.
TEST(DepthMarch, EqualsTheClosedFormForEqualSphericalPads) {
  const auto a = spherical_pad(), b = spherical_pad();
  for (const double part : {0.8, 1.1, 1.5, 2.0, 3.0}) {
    const double x = part * kThickness;
    const double force = kStiffness * kPi * (kRadius * x * x - 2.0 / 3.0 * x * x * x);
    const Contact c =
        touch(*a, *b, Pose{}, {glm::normalize(dquat(0.9, 0.1, 0.2, -0.3)), dvec3(0, 0, 2 * (kRadius - x))});
    EXPECT_NEAR(c.wrench.force.z, -force, 0.01 * force) << part;
    EXPECT_NEAR(c.surface.area(), kPi * (2 * kRadius * x - x * x), 0.005 * c.surface.area()) << part;
    EXPECT_EQ(pieces_of(c.surface) > 0, part > 1) << part;
    EXPECT_EQ(c.surface.at_core(), 0);
  }
}

/// A spherical pad against a half-space of the same E/H: R - r = -z on the surface, so with the centre at height c the
/// rim of height z has the radius s, s^2 = (R + z)^2 - (z - c)^2 = 2 (R + c) z + R^2 - c^2. The force is vertical, the
/// integral of p over the projection: F = (E/H) pi (R + c) z0^2 with z0 = -(R - c)/2, the lowest point.
TEST(DepthMarch, EqualsTheClosedFormForAPadInASoftHalfSpace) {
  const auto pad = spherical_pad();
  const auto mat = make_simple_body(ShapeType::plane, dvec3(0), soft_material(kModulus, kThickness));
  for (const double part : {0.5, 1.2, 2.0, 3.0}) {
    const double c = kRadius - 2 * part * kThickness, lowest = 0.5 * (kRadius - c);
    const double force = kStiffness * kPi * (kRadius + c) * lowest * lowest;
    const Contact on_pad = touch(*pad, *mat, at_height(c), Pose{});
    EXPECT_NEAR(on_pad.wrench.force.z, force, 0.01 * force) << part;
    const Contact on_mat = touch(*mat, *pad, Pose{}, at_height(c));
    EXPECT_NEAR(on_mat.wrench.force.z, -on_pad.wrench.force.z, 1e-9 * force) << part;
    EXPECT_EQ(pieces_of(on_pad.surface) > 0, part > 1) << part;
  }
}

TEST(DepthMarch, TreatsAStiffHalfSpaceLikeARigidOne) {
  const auto pad = spherical_pad(), plane = make_simple_body(ShapeType::plane, dvec3(0));
  const auto mat = make_simple_body(ShapeType::plane, dvec3(0), soft_material(1e5 * kModulus, kThickness));
  for (const double part : {1.2, 2.0, 3.0}) {
    const Pose X = at_height(kRadius - part * kThickness);
    const Contact soft = touch(*pad, *mat, X, Pose{}), rigid = touch(*pad, *plane, X, Pose{});
    EXPECT_NEAR(soft.wrench.force.z, rigid.wrench.force.z, 0.005 * rigid.wrench.force.z) << part;
  }
}

TEST(DepthMarch, GivesAForceThatGrowsWithDepth) {
  const auto tip = finger();
  const auto ball = make_simple_body(ShapeType::sphere, dvec3(0.008, 0, 0), soft_material(4 * kModulus), 0.0015);
  const auto pad = spherical_pad();
  double fingers_before = 0, ball_before = 0;
  for (double part = 0.5; part < 3; part += 0.25) {
    const Contact fingers = touch(*tip, *tip, Pose{}, side_on_tip(2 * part * kThickness));
    EXPECT_GT(glm::length(fingers.wrench.force), fingers_before) << part;
    fingers_before = glm::length(fingers.wrench.force);
    // A medial-axis field has no rigid core: beyond the tets of the pad, the tets of the medial-axis field continue.
    const Contact mixed = touch(*pad, *ball, Pose{}, at_height(kRadius + 0.008 - part * kThickness));
    EXPECT_GT(glm::length(mixed.wrench.force), ball_before) << part;
    EXPECT_EQ(mixed.surface.at_core(), 0);
    ball_before = glm::length(mixed.wrench.force);
  }
}

TEST(DepthMarch, ChangesTheForceLittleWithFinerLattices) {
  const auto tip = finger();
  IntersectWorkspace workspace, fine;
  fine.kernel->piece_size.min_edge = 0.08;
  ContactSurface surface;
  for (const double part : {2.0, 3.0, 5.0}) {
    intersect(*tip, *tip, Pose{}, side_on_tip(part * kThickness), surface, workspace);
    const double force = glm::length(pressure_wrench(surface).force), area = surface.area();
    EXPECT_GT(pieces_of(surface), 20);
    intersect(*tip, *tip, Pose{}, side_on_tip(part * kThickness), surface, fine);
    EXPECT_NEAR(force, glm::length(pressure_wrench(surface).force), 0.02 * force) << part;
    EXPECT_NEAR(area, surface.area(), 0.01 * area) << part;
  }
}

TEST(DepthMarch, GivesOppositeForcesInAnyFrame) {
  const auto tip = finger(), pad = spherical_pad();
  for (int i = 0; i < 5; ++i) {
    const Pose X_AB{glm::normalize(dquat(0.8, 0.3, 0.1 * i, 0.2)), dvec3(0.001, 0.002, 0.03 + kRadius - 0.0055)};
    const Pose motion = random_pose(4, i, 0.5);
    const Contact on_a = touch(*tip, *pad, Pose{}, X_AB), moved = touch(*tip, *pad, motion, motion * X_AB);
    const Contact on_b = touch(*pad, *tip, X_AB, Pose{});
    const double force = glm::length(on_a.wrench.force);
    EXPECT_GT(pieces_of(on_a.surface), 10);
    EXPECT_LT(glm::distance(on_a.wrench.force, moved.wrench.force), 1e-8 * force);
    EXPECT_LT(glm::distance(on_a.wrench.force, -X_AB.rotate(on_b.wrench.force)), 1e-8 * force);
  }
}

/// K = dF/dx of two spherical pads whose equal-pressure surface is beyond their tets, compared with the difference of
/// forces along the axis.
TEST(DepthMarch, GivesTheSlopeOfTheForceAsStiffness) {
  const auto a = spherical_pad(), b = spherical_pad();
  const auto at_depth = [](double x) { return at_height(2 * (kRadius - x)); };
  const double x = 2.5 * kThickness, step = 1e-5;
  const Contact c = touch(*a, *b, Pose{}, at_depth(x));
  const double above = touch(*a, *b, Pose{}, at_depth(x + step)).wrench.force.z;
  const double below = touch(*a, *b, Pose{}, at_depth(x - step)).wrench.force.z;
  const double slope = std::abs(above - below) / (4 * step);  // the bodies approach by 2 x
  EXPECT_NEAR(contact_stiffness(c.surface, *a, *b, RigidTransform(at_depth(x)))[2][2], slope, 0.03 * slope);
}

/// A small pad wholly inside a large one, where no tets of the large pad reach its skin.
TEST(DepthMarch, FindsTheSurfaceOfAPadInsideARigidCore) {
  const auto large = make_mesh_body(make_box(dvec3(0.03)), all_faces(soft_material(kModulus, 0.001)));
  const auto small = make_mesh_body(make_icosphere(0.004, 3), all_faces(soft_material(40 * kModulus, 0.001)));
  const Contact c = touch(*large, *small, Pose{}, at_height(0.03 - 0.010));
  ASSERT_FALSE(c.surface.empty());
  // The small pad is nearly rigid compared with the large one, and D is the depth below the large one's top: F is about
  // (E/H) V (A3).
  const double force = kModulus / 0.001 * 4.0 / 3.0 * kPi * std::pow(0.004, 3);
  EXPECT_LT(c.wrench.force.z, -0.7 * force);
  EXPECT_GT(c.wrench.force.z, -force);
}

TEST(DepthMarch, AllocatesNothingAfterWarmUp) {
  const auto tip = finger();
  const Pose X = side_on_tip(3 * kThickness);
  ContactSurface surface;
  IntersectWorkspace workspace;
  intersect(*tip, *tip, Pose{}, X, surface, workspace);
  intersect(*tip, *tip, Pose{}, X, surface, workspace);
  const long before = allocation_count();
  intersect(*tip, *tip, Pose{}, X, surface, workspace);
  EXPECT_EQ(allocation_count(), before);
}

TEST(DepthMarch, GivesTheSameBitsOnAllInstructionSets) {
  const auto tip = finger();
  const Pose X = side_on_tip(3 * kThickness);
  const ContactSurface usual = touch(*tip, *tip, Pose{}, X).surface;
  test::for_each_set([&](std::int64_t target) {
    const ContactSurface found = test::on_target(target, [&] { return touch(*tip, *tip, Pose{}, X).surface; });
    ASSERT_EQ(found.vertices, usual.vertices);
    ASSERT_EQ(found.pressure, usual.pressure);
  });
}

}  // namespace
}  // namespace taxel
