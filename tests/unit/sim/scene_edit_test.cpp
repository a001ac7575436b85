// Values that a user sets between two steps: controls, joints, mocap bodies, equalities, keyframes, and a dragged body.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/sim/simulator.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

constexpr const char* kScene = R"(<mujoco><option timestep='0.001' gravity='0 0 0'/><worldbody>
  <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
  <body name='ball' pos='0 0 1'><freejoint/><geom name='ball' type='sphere' size='.05' mass='2'/></body>
  <body name='arm' pos='1 0 0'><joint name='elbow' axis='0 1 0' range='-90 45' damping='1'/>
    <geom name='arm' type='capsule' fromto='0 0 0 0 0 .3' size='.02'/>
    <body name='rod' pos='0 0 .3'><joint name='rod' type='slide' axis='0 0 1'/>
      <geom name='rod' type='box' size='.01 .01 .1'/></body></body>
  <body name='lead' mocap='true' pos='0 1 0'><geom name='lead' type='box' size='.01 .01 .01'/></body>
  <body name='led' pos='0 1 0' euler='0 0 30'><freejoint/><geom name='led' type='box' size='.02 .02 .02'/></body>
  </worldbody>
  <equality><weld name='hold' body1='lead' body2='led' anchor='.1 .02 .03'/>
    <connect name='hinge' body1='arm' body2='ball' anchor='0 0 .1' active='false'/></equality>
  <actuator><motor name='turn' joint='elbow' ctrlrange='-1 2'/><motor name='push' joint='rod'/></actuator>
  <keyframe><key name='bent' time='2' qpos='0 0 1 1 0 0 0 .5 .01 0 1 0 1 0 0 0' ctrl='.25 0'/></keyframe></mujoco>)";

class SceneEdits : public testing::Test {
 protected:
  void SetUp() override {
    write_file_atomically(s_.folder / "scene.xml", kScene);
    simulator = Simulator::load(s_.folder / "scene.xml");
  }
  SimFrame frame() const {
    SimFrame f;
    test::fill_frame(*simulator, f);
    return f;
  }
  int geom(const std::string& name) const {
    const auto& geoms = simulator->scene()->geoms;
    for (std::size_t g = 0; g < geoms.size(); ++g)
      if (geoms[g].name == name) return static_cast<int>(g);
    return -1;
  }
  Pose pose(const std::string& name) const {
    return simulator->view().geom_poses.at(static_cast<std::size_t>(geom(name)));
  }
  dvec3 place(const std::string& name) const { return pose(name).p; }
  Perturb pull(const std::string& name, const dvec3& moved, bool running) const {
    Perturb hand;
    hand.kind = Perturb::Kind::pull;
    hand.geom = geom(name);
    hand.moved_W = moved;
    hand.running = running;
    return hand;
  }
  test::SensorScene s_;
  std::unique_ptr<Simulator> simulator;
};

TEST_F(SceneEdits, AreDescribedAndRead) {
  const SceneControls& c = simulator->scene()->controls;
  ASSERT_EQ(c.actuators.size(), 2U);
  EXPECT_EQ(c.actuators[0].name, "turn");
  EXPECT_EQ(c.actuators[0].range, (ControlRange{-1, 2}));
  EXPECT_FALSE(c.actuators[1].range.has_value());
  ASSERT_EQ(c.joints.size(), 2U);  // free joints have no single value
  EXPECT_TRUE(c.joints[0].hinge);
  EXPECT_NEAR((*c.joints[0].range)[1], kPi / 4, 1e-12);
  EXPECT_FALSE(c.joints[1].hinge);
  EXPECT_EQ(c.mocaps, (std::vector<std::string>{"lead"}));
  ASSERT_EQ(c.equalities.size(), 2U);
  EXPECT_EQ(c.equalities[0].kind, "weld");
  EXPECT_EQ(c.keyframes[0].name, "bent");
  EXPECT_TRUE(c.bodies[0].fixed);
  EXPECT_FALSE(c.bodies[1].fixed);
  EXPECT_EQ(frame().controls.equalities, (std::vector<bool>{true, false}));
  EXPECT_EQ(frame().controls.mocaps[0].p, dvec3(0, 1, 0));
}

TEST_F(SceneEdits, SetValuesAndIgnoreNonsense) {
  simulator->edit(SetControl{0, 7});  // clamped to the range
  simulator->edit(SetControl{1, -3});
  simulator->edit(SetControl{5, 1});
  simulator->edit(SetControl{1, std::nan("")});
  simulator->edit(SetJoint{0, 0.5});
  simulator->edit(SetJoint{-1, 0.5});
  simulator->edit(SetMocap{0, {{0, 0, 0, 0}, {1, 1, 1}}});  // not an orientation
  simulator->edit(SetMocap{0, {{2, 0, 0, 0}, {0, 2, 0}}});
  simulator->edit(SetEquality{1, true});
  simulator->edit(SetEquality{2, true});
  const ControlValues now = frame().controls;
  EXPECT_EQ(now.controls, (std::vector<double>{2, -3}));
  EXPECT_EQ(now.joints, (std::vector<double>{0.5, 0}));
  EXPECT_EQ(now.mocaps[0].p, dvec3(0, 2, 0));
  EXPECT_EQ(now.mocaps[0].q.w, 1);
  EXPECT_EQ(now.equalities, (std::vector<bool>{true, true}));
  // Visible at once, before any step.
  EXPECT_NEAR(place("rod").x, 1 + 0.3 * std::sin(0.5), 1e-12);
  EXPECT_EQ(place("lead"), dvec3(0, 2, 0));
  SimState state;
  simulator->save_state(state);
  const ControlValues saved = simulator->controls_of(state);
  EXPECT_EQ(saved.controls, now.controls);
  EXPECT_EQ(saved.joints, now.joints);
  EXPECT_EQ(saved.equalities, now.equalities);
  EXPECT_EQ(saved.mocaps[0].p, now.mocaps[0].p);
}

TEST_F(SceneEdits, StartFromAKeyframeAndResetToTheFirst) {
  for (int n = 0; n < 10; ++n) simulator->step();
  EXPECT_FALSE(simulator->load_keyframe(1));
  ASSERT_TRUE(simulator->load_keyframe(0));
  EXPECT_EQ(simulator->view().step, 0U);
  EXPECT_EQ(simulator->view().time, 2);
  EXPECT_EQ(frame().controls.joints, (std::vector<double>{0.5, 0.01}));
  EXPECT_EQ(frame().controls.controls[0], 0.25);
  simulator->reset();
  EXPECT_EQ(frame().controls.joints, (std::vector<double>{0, 0}));
  EXPECT_EQ(simulator->view().time, 0);
}

/// The control of a step is that of the step's time, before the step, whatever computes the step.
TEST(SceneLead, LeadsEachStepAtItsTimeInEveryIntegrator) {
  const test::SensorScene s;
  const double timestep = 0.001, mass = 2;
  SceneLead lead;
  lead.controls.push_back({0, {0, 0.05, 0.1}, {0, 1, 0}});
  lead.mocaps.push_back({0, {0, 0.1}, {{0, 0, 1}, {0.2, 0, 1}}, {}});
  for (const char* integrator : {"Euler", "RK4", "implicit", "implicitfast"}) {
    write_file_atomically(
        s.folder / "push.xml",
        fmt::format("<mujoco><option timestep='{}' gravity='0 0 0' integrator='{}'/><worldbody><body><joint name='x' "
                    "type='slide' axis='1 0 0'/><geom size='.1' mass='{}'/></body><body mocap='true' pos='0 0 1' "
                    "quat='0 1 0 0'/></worldbody><actuator><motor joint='x'/></actuator></mujoco>",
                    timestep, integrator, mass));
    const std::unique_ptr<Simulator> simulator = Simulator::load(s.folder / "push.xml");
    simulator->lead(std::make_shared<SceneLead>(lead));
    for (int run = 0; run < 2; ++run) {  // the second run follows a reset
      for (int step = 0; step < 150; ++step) {
        simulator->step();
        SimFrame frame;
        test::fill_frame(*simulator, frame);
        const double time = step * timestep;
        EXPECT_NEAR(frame.controls.controls[0], std::max(0.0, time < 0.05 ? time / 0.05 : 2 - time / 0.05), 1e-12);
        EXPECT_NEAR(frame.controls.mocaps[0].p.x, 2 * std::min(time, 0.1), 1e-12) << integrator << step;
        EXPECT_EQ(frame.controls.mocaps[0].q, dquat(0, 1, 0, 0)) << "no column leads the orientation";
        EXPECT_NEAR(simulator->view().travel, 2 * std::min(time, 0.1), 1e-12);
      }
      // The impulse of the triangle is 0.05 N s: x = v (t - 0.05 s) with v = 0.05 / mass.
      SimFrame frame;
      test::fill_frame(*simulator, frame);
      EXPECT_NEAR(frame.controls.joints[0], 0.05 / mass * 0.1, 0.02 * 0.05 / mass * 0.1) << integrator;
      simulator->reset();
    }
    simulator->lead(nullptr);
    simulator->edit(SetControl{0, 0.5});
    simulator->step();
    SimFrame frame;
    test::fill_frame(*simulator, frame);
    EXPECT_EQ(frame.controls.controls[0], 0.5);
  }
}

TEST_F(SceneEdits, ReportTheConstraintPointsOfAWeld) {
  const std::vector<ConstraintPoints> held = frame().constraint_points;
  ASSERT_EQ(held.size(), 1U);  // the connection is off
  EXPECT_TRUE(held[0].weld);
  // The anchor is a point of the second body, which is rotated by 30 degrees and is at the place of the first one.
  const double c = std::cos(kPi / 6), s = std::sin(kPi / 6);
  const dvec3 expected = dvec3(0, 1, 0) + dvec3(c * 0.1 - s * 0.02, s * 0.1 + c * 0.02, 0.03);
  EXPECT_LT(glm::length(held[0].a_W - expected), 1e-9);
  EXPECT_LT(glm::length(held[0].b_W - expected), 1e-9);
  simulator->edit(SetMocap{0, {{1, 0, 0, 0}, {0, 1, 0.1}}});
  EXPECT_NEAR(frame().constraint_points[0].a_W.z, 0.13, 1e-9);
  EXPECT_NEAR(frame().constraint_points[0].b_W.z, 0.03, 1e-9);
  simulator->edit(SetEquality{1, true});
  EXPECT_EQ(frame().constraint_points.size(), 2U);
}

/// The spring is MuJoCo's: stiffness times the effective mass, critically damped. Nothing of it remains after the
/// release.
TEST_F(SceneEdits, PullAFreeBodyByASpringInARun) {
  SimState before, after;
  simulator->save_state(before);
  simulator->edit(pull("ball", {0, 0, 0.1}, true));
  EXPECT_EQ(place("ball"), dvec3(0, 0, 1));  // no jump
  ASSERT_TRUE(frame().perturbed.has_value());
  EXPECT_EQ(frame().perturbed->target_W, dvec3(0, 0, 1.1));
  simulator->step();
  simulator->step();
  // A free body at rest: a = k x, k = vis.map.stiffness = 100 by default.
  EXPECT_NEAR(place("ball").z - 1, 100 * 0.1 * 1e-6, 1e-9);
  for (int n = 0; n < 2000; ++n) simulator->step();
  EXPECT_NEAR(place("ball").z, 1.1, 1e-3);
  simulator->edit(Perturb{});
  EXPECT_FALSE(frame().perturbed.has_value());
  simulator->save_state(after);
  EXPECT_EQ(after.integration.size(), before.integration.size());
  const double z = place("ball").z;
  for (int n = 0; n < 100; ++n) simulator->step();
  EXPECT_NEAR(place("ball").z, z, 1e-3);
}

TEST_F(SceneEdits, ForgetTheDragAfterItsRelease) {
  simulator->edit(pull("ball", {0, 0, 0.1}, true));
  for (int n = 0; n < 20; ++n) simulator->step();
  simulator->edit(Perturb{});
  simulator->step();
  const double z0 = place("ball").z;
  for (int n = 0; n < 100; ++n) simulator->step();
  const double z1 = place("ball").z;
  for (int n = 0; n < 100; ++n) simulator->step();
  EXPECT_GT(z1 - z0, 1e-3);
  EXPECT_NEAR(place("ball").z - z1, z1 - z0, 1e-9);  // the ball continues with its velocity
}

TEST_F(SceneEdits, DragAPausedFreeBodyAndNoFixedOne) {
  simulator->edit(pull("ball", {0.2, 0, 0.1}, false));
  EXPECT_LT(glm::length(place("ball") - dvec3(0.2, 0, 1.1)), 1e-12);
  simulator->edit(Perturb{});
  Perturb turn = pull("ball", dvec3(0), false);
  turn.kind = Perturb::Kind::turn;
  turn.grip = 1;
  turn.turned_W = glm::angleAxis(0.5, dvec3(0, 0, 1));
  simulator->edit(turn);
  EXPECT_NEAR(std::abs(glm::dot(pose("ball").q, turn.turned_W)), 1, 1e-12);
  EXPECT_NEAR(glm::angle(pose("ball").q), 0.5, 1e-9);
  simulator->edit(pull("arm", {1, 1, 1}, false));  // attached by a joint
  EXPECT_EQ(place("arm"), dvec3(1, 0, 0.15));
  simulator->edit(pull("lead", {0.5, 0, 0}, true));  // a mocap body moves in any case
  EXPECT_EQ(place("lead"), dvec3(0.5, 1, 0));
  simulator->edit(pull("floor", {1, 0, 0}, true));
  simulator->step();
  EXPECT_EQ(place("floor"), dvec3(0));
}

/// The dragged body moves. All other bodies move as without the drag.
TEST_F(SceneEdits, ChangeNoStepAfterADragIsReleased) {
  const auto other = Simulator::load(s_.folder / "scene.xml");
  simulator->edit(pull("ball", {0, 0, 0.1}, true));
  simulator->edit(Perturb{});
  for (int n = 0; n < 50; ++n) {
    simulator->step();
    other->step();
  }
  SimState a, b;
  simulator->save_state(a);
  other->save_state(b);
  EXPECT_EQ(a.integration, b.integration);
}

}  // namespace
}  // namespace taxel
