// Bristles in MuJoCo's state: a press, a push and a deeper press of one bristle, and two bodies on one root.
#include "core/sim/plugin/pairs/skin_bristles.h"

#include <gtest/gtest.h>

#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kBallRadius = 0.02, kDepth = 0.002, kPush = 1e-5;
constexpr int kGeoms = 2;

/// A soft ball whose whole contact is on one bristle, above rigid floors. The frame is that of the ball.
struct OneBristle {
  const BristleSettings settings{1e7, 1, true};
  HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(kBallRadius), soft_material(5e4), 0.002);
  HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  SkinBristles bristles{*ball, settings};
  std::vector<mjtNum> state = std::vector<mjtNum>(static_cast<std::size_t>(bristle_state_size(settings, kGeoms)), 0.0);

  /// Returns the pose of a floor that is pressed into the ball and moved along x.
  [[nodiscard]] static Pose floor_at(double depth, double x) {
    return {dquat(1, 0, 0, 0), {x, 0, depth - kBallRadius}};
  }
  /// Reads the bristle of geom `geom`, which is pair `geom`, for a floor at this pose.
  const Bristle& read(int geom, const Pose& X_MB) {
    bristles.forget_surfaces();
    const auto pair = static_cast<std::size_t>(geom);
    bristles.read(pair, touch(*ball, *floor, Pose{}, X_MB).surface, geom, X_MB, state);
    EXPECT_EQ(bristles.contact(pair).bristles().size(), 1U);
    return bristles.contact(pair).bristles().front();
  }
  /// Ends a step in which the floors at these poses touch, in this order, and nothing slips.
  void end_step(const std::vector<std::pair<int, Pose>>& touching) {
    bristles.begin(state.size());
    const BristleLaw law{settings.stiffness, {0, 1e9}, 0, 0};
    for (const auto& [geom, X_MB] : touching) {
      read(geom, X_MB);
      bristles.write(static_cast<std::size_t>(geom), geom, X_MB, law, Twist{}, state);
    }
    state.assign(bristles.written().begin(), bristles.written().end());
  }
};

// The ball moves by -dx relative to the floor, so that the force is k a dx with the area a of the first press. A deeper
// press adds area without deflection: the product of area and deflection stays. A lighter press loses area with its
// force.
TEST(SkinBristles, AttachNewAreaWithoutDeflection) {
  OneBristle one;
  EXPECT_EQ(one.read(0, OneBristle::floor_at(kDepth, 0)).u, dvec3(0));
  one.end_step({{0, OneBristle::floor_at(kDepth, 0)}});
  const Bristle pushed = one.read(0, OneBristle::floor_at(kDepth, kPush));
  EXPECT_NEAR(pushed.u.x, -kPush, 1e-15);
  EXPECT_NEAR(glm::length(pushed.u), kPush, 1e-15);
  one.end_step({{0, OneBristle::floor_at(kDepth, kPush)}});
  const Bristle deeper = one.read(0, OneBristle::floor_at(2 * kDepth, kPush));
  ASSERT_GT(deeper.area, 1.5 * pushed.area);
  EXPECT_NEAR(deeper.area * deeper.u.x, -pushed.area * kPush, 1e-9 * pushed.area * kPush);
  EXPECT_NEAR(deeper.u.z, 0, 1e-15) << "deflections are tangential";
  one.end_step({{0, OneBristle::floor_at(2 * kDepth, kPush)}});
  const Bristle lighter = one.read(0, OneBristle::floor_at(kDepth, kPush));
  EXPECT_NEAR(lighter.area, pushed.area, 1e-9 * pushed.area);
  EXPECT_NEAR(lighter.u.x, deeper.u.x, 1e-9 * kPush);
}

// The first floor has the root. A second floor that touches the same root has no deflection there, and does not take
// the root from the first floor, whichever of them is written first.
TEST(SkinBristles, LeaveASharedRootToTheBodyThatHadIt) {
  for (const bool is_second_first : {false, true}) {
    OneBristle one;
    const Pose start = OneBristle::floor_at(kDepth, 0), moved = OneBristle::floor_at(kDepth, kPush);
    one.end_step({{0, start}});
    const std::pair<int, Pose> first{0, moved}, second{1, start};
    one.end_step(is_second_first ? std::vector{second, first} : std::vector{first, second});
    EXPECT_EQ(one.state[0], 1) << "the number of the first geom, plus 1";
    EXPECT_NEAR(one.state[1], -kPush, 1e-15);
    EXPECT_NEAR(one.read(0, OneBristle::floor_at(kDepth, 3 * kPush)).u.x, -3 * kPush, 1e-15);
    EXPECT_EQ(one.read(1, moved).u, dvec3(0));
  }
}

// A root that the first floor has left belongs to the second one from then on, from its present place.
TEST(SkinBristles, GiveAFreeRootToTheNextBody) {
  OneBristle one;
  const Pose start = OneBristle::floor_at(kDepth, 0), moved = OneBristle::floor_at(kDepth, kPush);
  one.end_step({{0, start}});
  one.end_step({{1, moved}});
  EXPECT_EQ(one.state[0], 2);
  EXPECT_EQ(one.read(0, moved).u, dvec3(0));
  EXPECT_EQ(one.read(1, moved).u, dvec3(0));
  EXPECT_NEAR(one.read(1, OneBristle::floor_at(kDepth, 2 * kPush)).u.x, -kPush, 1e-15);
}

}  // namespace
}  // namespace taxel
