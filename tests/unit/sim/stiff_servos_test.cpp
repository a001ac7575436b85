// Servos whose damping MuJoCo integrates implicitly: contact forces know the velocity at the end of the step.
#include <gtest/gtest.h>

#include "core/hydro/traction.h"
#include "core/sim/plugin/forces/stiff_servos.h"
#include "core/sim/plugin/pairs/body_contacts.h"
#include "core/sim/plugin/pairs/declared_bodies.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::SensorScene;

constexpr double kMass = 0.01, kTimestep = 0.002;

/// A soft tip of 10 g that weight presses on a rigid floor. Two servos with h kv/m = `ratio` move the tip sideways and
/// up and down.
struct PressedTip {
  SensorScene s;
  PressedTip(const std::string& integrator, double ratio, const std::string& servo = "", const std::string& keys = "") {
    const std::string kv = std::to_string(ratio * kMass / kTimestep);
    s.compile("<mujoco><option timestep='0.002' integrator='" + integrator +
              R"('/><default><geom contype='0' conaffinity='0'/></default><extension><plugin plugin='taxel.contact'>
      <instance name='tip'><config key='materials' value='{"tip": {"modulus": 1e5, "dissipation": 5, "friction": 0.8}}'/>
      <config key='pairs' value='tip floor'/>)" +
              keys + R"(</instance></plugin></extension><worldbody>
      <geom name='floor' type='plane' size='1 1 1' friction='0.8'/><body pos='0 0 0.0099'>
      <joint name='slide' type='slide' axis='1 0 0'/><joint name='press' type='slide' axis='0 0 1'/>
      <geom name='tip' type='sphere' size='0.01' mass='0.01'/></body></worldbody>
      <actuator><velocity name='servo' joint='slide' kv=')" +
              kv + "' " + servo + "/><velocity name='lift' joint='press' kv='" + kv + "'/></actuator></mujoco>");
    if (s.model == nullptr) throw Error(s.error);
  }
  [[nodiscard]] BodyContacts& body() { return own_body(*s.model, *s.data, {0, 0}); }
  /// Makes a step and returns the difference of the velocity that the contact had taken for its end, and the one that
  /// it has [m/s].
  double error_of_step() {
    s.step();
    const PairState& pair = body().latest().pairs.at(0);
    EXPECT_FALSE(pair.surface.empty());
    return glm::length(pair.V_rub.linear - dvec3(s.data->qvel[0], 0, s.data->qvel[1]));
  }
};

class StiffServosUnder : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, StiffServosUnder, testing::Values("implicit", "implicitfast", "discrete"),
                         [](const auto& test) { return test.param; });

TEST_P(StiffServosUnder, LetContactsKnowTheVelocityAtTheEndOfTheStep) {
  for (const std::string& keys : {std::string(), test::key("tangential_stiffness", "1e7")}) {
    for (const double ratio : {200.0, 1e4, 1e6}) {
      PressedTip tip(GetParam(), ratio, "", keys);
      tip.s.step(20);
      double largest = 0;
      for (const dvec2 velocity : {dvec2(0.01, 0), dvec2(-0.02, 0), dvec2(0, -0.005), dvec2(0.01, 0.004), dvec2(0)}) {
        tip.s.data->ctrl[0] = velocity.x;
        tip.s.data->ctrl[1] = velocity.y;
        for (int n = 0; n < 3; ++n) largest = std::max(largest, tip.error_of_step());
        EXPECT_NEAR(tip.s.data->qvel[0], velocity.x, 1e-3) << ratio;
      }
      EXPECT_LT(largest, 1e-8) << ratio << keys;
    }
  }
}

TEST_P(StiffServosUnder, LetContactsHaveTheDampingForceOfTheStep) {
  PressedTip tip(GetParam(), 1000);
  tip.s.step(20);
  tip.s.data->ctrl[0] = 0.01;
  tip.s.data->ctrl[1] = -0.005;
  tip.s.step();
  const PairState& pair = tip.body().latest().pairs.at(0);
  const Twist end{{tip.s.data->qvel[0], 0, tip.s.data->qvel[1]}, dvec3(0)};
  const dvec3 expected = traction(pair.surface, tip.body().touched().at(0).properties, end).wrench.force;
  EXPECT_LT(glm::length(pair.wrench.force - expected), 1e-5 * glm::length(expected));
}

TEST_P(StiffServosUnder, HaveNoDampingWhereTheirForceIsClamped) {
  PressedTip tip(GetParam(), 1e4, "forcelimited='true' forcerange='-0.05 0.05'");
  tip.s.step(20);
  tip.s.data->ctrl[0] = 0.5;
  double largest = 0;
  for (int n = 0; n < 5; ++n) largest = std::max(largest, tip.error_of_step());
  EXPECT_LT(tip.s.data->qvel[0], 0.1);
  EXPECT_LT(largest, 1e-8);
}

TEST_P(StiffServosUnder, RepeatRestoredStates) {
  PressedTip tip(GetParam(), 1e4);
  tip.s.data->ctrl[0] = 0.01;
  tip.s.step(10);
  std::vector<mjtNum> state(static_cast<std::size_t>(mj_stateSize(tip.s.model.get(), mjSTATE_INTEGRATION)));
  mj_getState(tip.s.model.get(), tip.s.data.get(), state.data(), mjSTATE_INTEGRATION);
  tip.s.step(5);
  const std::vector<mjtNum> expected(tip.s.data->qpos, tip.s.data->qpos + 2);
  mj_setState(tip.s.model.get(), tip.s.data.get(), state.data(), mjSTATE_INTEGRATION);
  tip.s.step(5);
  EXPECT_EQ(std::vector<mjtNum>(tip.s.data->qpos, tip.s.data->qpos + 2), expected);
}

TEST(StiffServos, AreThoseAboveTheLimit) {
  EXPECT_FALSE(has_stiff_servos(*PressedTip("implicitfast", 99).s.model));
  EXPECT_TRUE(has_stiff_servos(*PressedTip("implicitfast", 101).s.model));
  EXPECT_TRUE(has_stiff_servos(*PressedTip("implicit", 101).s.model));
  EXPECT_FALSE(has_stiff_servos(*PressedTip("Euler", 101).s.model));
  EXPECT_TRUE(PressedTip("implicitfast", 1e6).body().warnings.empty());
}

TEST(StiffServos, AreNamedWhereAPluginComputesAnActuator) {
  PressedTip tip("implicitfast", 120);
  EXPECT_TRUE(stiff_servo_warnings(*tip.s.model).empty());
  tip.s.model->actuator_plugin[1] = 0;
  const std::vector<std::string> warnings = stiff_servo_warnings(*tip.s.model);
  tip.s.model->actuator_plugin[1] = -1;
  ASSERT_EQ(warnings.size(), 2U);
  for (const char* part : {"\"servo\"", "\"slide\" is 120", "smaller kv"})
    EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace taxel
