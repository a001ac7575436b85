// The plugin under all ways in which MuJoCo calls it: copies, restored states, skipped stages, several sensors.
#include <gtest/gtest.h>

#include <cstring>

#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

/// A soft ball that drops on the floor and slides, attached by a spring to a mocap body.
class PluginState : public testing::Test {
 protected:
  void SetUp() override { compile(""); }
  void compile(const std::string& option) {
    s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
    s.compile("<mujoco><option timestep='0.001'>" + option + "</option>" +
              sensor_extension("ball", key("others", "floor") + key("output", "readings wrench area")) +
              R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
      <body name='hand' mocap='true' pos='0 0 0.0185'/>
      <body name='ball' pos='0 0 0.0185'><freejoint/><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body>
      </worldbody><equality><weld body1='hand' body2='ball' solref='0.02 1'/></equality></mujoco>)");
    ASSERT_NE(s.model, nullptr) << s.error;
  }
  void push_along(mjData& d, int n) { d.mocap_pos[0] = 1e-5 * n; }
  std::vector<double> run(mjData& d, int from, int count) {
    std::vector<double> out;
    for (int n = from; n < from + count; ++n) {
      push_along(d, n);
      mj_step(s.model.get(), &d);
      out.insert(out.end(), d.sensordata, d.sensordata + s.model->nsensordata);
      out.insert(out.end(), d.qpos, d.qpos + s.model->nq);
    }
    return out;
  }
  SensorScene s;
};

TEST_F(PluginState, GivesTheSameBytesAfterAReset) {
  const std::vector<double> first = run(*s.data, 0, 60);
  mj_resetData(s.model.get(), s.data.get());
  EXPECT_EQ(run(*s.data, 0, 60), first);
  EXPECT_GT(first[0] + first[1] + first[2] + first[3], 0);
}

TEST_F(PluginState, ContinuesInACopyThatOutlivesTheOriginal) {
  run(*s.data, 0, 30);
  DataHandle copy(mj_copyData(nullptr, s.model.get(), s.data.get()));
  DataHandle second(mj_makeData(s.model.get()));
  mj_copyData(second.get(), s.model.get(), s.data.get());  // into data that already has a sensor
  ASSERT_NE(find_sensor(*copy, 0), find_sensor(*s.data, 0));
  const std::vector<double> original = run(*s.data, 30, 30);
  s.data.reset();
  EXPECT_EQ(run(*copy, 30, 30), original);
  copy.reset();
  EXPECT_EQ(run(*second, 30, 30), original);
}

TEST_F(PluginState, RepeatsARestoredStateBitForBit) {
  run(*s.data, 0, 30);
  std::vector<mjtNum> state(static_cast<std::size_t>(mj_stateSize(s.model.get(), mjSTATE_INTEGRATION)));
  mj_getState(s.model.get(), s.data.get(), state.data(), mjSTATE_INTEGRATION);
  const std::vector<double> original = run(*s.data, 30, 30);
  DataHandle other(mj_makeData(s.model.get()));
  run(*other, 500, 7);  // a completely different state
  mj_setState(s.model.get(), other.get(), state.data(), mjSTATE_INTEGRATION);
  EXPECT_EQ(run(*other, 30, 30), original);
}

TEST_F(PluginState, IsUnchangedByForward) {
  const std::vector<double> plain = run(*s.data, 0, 60);
  mj_resetData(s.model.get(), s.data.get());
  std::vector<double> disturbed;
  for (int n = 0; n < 60; ++n) {
    mj_forward(s.model.get(), s.data.get());
    mj_forwardSkip(s.model.get(), s.data.get(), mjSTAGE_POS, 0);
    const std::vector<double> row = run(*s.data, n, 1);
    disturbed.insert(disturbed.end(), row.begin(), row.end());
  }
  // mj_forward leaves its own warm start for MuJoCo's solver, so the results are equal up to this and not to the last
  // bit.
  ASSERT_EQ(plain.size(), disturbed.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(disturbed[i], plain[i], 1e-7 * (1 + std::abs(plain[i])));
}

TEST_F(PluginState, MakesOneStepOfTwoHalves) {
  const std::vector<double> whole = run(*s.data, 0, 40);
  mj_resetData(s.model.get(), s.data.get());
  std::vector<double> halves;
  for (int n = 0; n < 40; ++n) {
    push_along(*s.data, n);
    mj_step1(s.model.get(), s.data.get());
    mj_step2(s.model.get(), s.data.get());
    halves.insert(halves.end(), s.data->sensordata, s.data->sensordata + s.model->nsensordata);
    halves.insert(halves.end(), s.data->qpos, s.data->qpos + s.model->nq);
  }
  EXPECT_EQ(halves, whole);
}

TEST_F(PluginState, ReadsCorrectlyIfPassiveForcesAreOff) {
  mj_forward(s.model.get(), s.data.get());
  const std::vector<double> with(s.data->sensordata, s.data->sensordata + s.model->nsensordata);
  s.model->opt.disableflags |= mjDSBL_SPRING | mjDSBL_DAMPER;  // MuJoCo then skips the PASSIVE stage
  DataHandle other(mj_makeData(s.model.get()));
  mj_forward(s.model.get(), other.get());
  EXPECT_GT(with[0], 0);
  EXPECT_EQ(other->sensordata[0], with[0]);                             // reading
  EXPECT_EQ(other->sensordata[s.model->nsensordata - 1], with.back());  // area
  for (int i = 0; i < s.model->nv; ++i) EXPECT_EQ(other->qfrc_passive[i], 0);
  // The readings follow the state.
  other->qpos[2] += 0.0005;
  mj_forward(s.model.get(), other.get());
  EXPECT_LT(other->sensordata[0], with[0]);
  EXPECT_GT(other->sensordata[0], 0);
}

TEST_F(PluginState, AppliesForcesIfSensorsAreOff) {
  s.model->opt.disableflags |= mjDSBL_SENSOR;
  s.step(5);
  EXPECT_GT(s.data->qfrc_passive[2], 0);
}

TEST_F(PluginState, ReadsTheStartOfTheStepUnderRungeKutta) {
  s.model->opt.integrator = mjINT_RK4;
  run(*s.data, 0, 30);
  DataHandle probe(mj_makeData(s.model.get()));
  for (int n = 30; n < 40; ++n) {
    mj_copyState(s.model.get(), s.data.get(), probe.get(), mjSTATE_INTEGRATION);
    push_along(*s.data, n);
    push_along(*probe, n);
    mj_forward(s.model.get(), probe.get());
    mj_step(s.model.get(), s.data.get());
    EXPECT_EQ(std::memcmp(s.data->sensordata, probe->sensordata,
                          sizeof(mjtNum) * static_cast<std::size_t>(s.model->nsensordata)),
              0);
    EXPECT_EQ(find_sensor(*s.data, 0)->sensed().X_WM.p, find_sensor(*probe, 0)->sensed().X_WM.p);
    EXPECT_EQ(find_sensor(*s.data, 0)->reading().values[0], s.data->sensordata[0]);
  }
}

TEST_F(PluginState, MakesItsOwnSensorForABitwiseCopy) {
  run(*s.data, 0, 30);
  // As in Python's pickle: a new mjData whose arrays are overwritten, including plugin_data.
  DataHandle copy(mj_makeData(s.model.get()));
  const std::uintptr_t own_entry = copy->plugin_data[0];
  copy->plugin_data[0] = s.data->plugin_data[0];
  EXPECT_EQ(find_sensor(*copy, 0), nullptr);
  run(*copy, 0, 3);
  ASSERT_NE(find_sensor(*copy, 0), nullptr);
  EXPECT_NE(find_sensor(*copy, 0), find_sensor(*s.data, 0));
  EXPECT_GT(copy->sensordata[0], 0);
  // Frees the sensor that pickling loses.
  const std::uintptr_t made = copy->plugin_data[0];
  copy->plugin_data[0] = own_entry;
  mjp_getPlugin(kPluginName, nullptr)->destroy(copy.get(), 0);
  copy->plugin_data[0] = made;
}

TEST_F(PluginState, KeepsATouchedBallAwakeAndAtRest) {
  compile("<flag sleep='enable'/>");
  s.model->eq_active0[0] = 0;
  mj_resetData(s.model.get(), s.data.get());
  s.step(1500);  // at rest on the floor for a long time
  EXPECT_EQ(s.data->body_awake[s.model->geom_bodyid[s.sensor().config().geom]], mjS_AWAKE);
  EXPECT_LT(std::abs(s.data->qvel[2]), 1e-6);
  const double weight = 9.81 * s.model->body_mass[2];
  EXPECT_NEAR(s.data->qfrc_passive[2], weight, 1e-3 * weight);
}

/// A mocap body moves a sensor back and forth over a box that rests on the floor. The box has MuJoCo's contact with the
/// floor and the plugin's contact with the sensor. Nothing touches the second box.
TEST(SleepingBodies, DoNotIncludeABoxUnderAMovingSensor) {
  SensorScene s;
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  s.compile("<mujoco><option timestep='0.001'><flag sleep='enable'/></option>" +
            sensor_extension("ball", key("others", "box")) +
            R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='2 2 1'/>
      <body name='hand' mocap='true' pos='0 0 0.059'><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body>
      <body name='box' pos='0 0 0.02'><freejoint/><geom name='box' type='box' size='0.05 0.05 0.02' mass='1'/></body>
      <body name='other' pos='1 0 0.02'><freejoint/><geom name='other' type='box' size='0.05 0.05 0.02' mass='1'/></body>
      </worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const int box = mj_name2id(s.model.get(), mjOBJ_BODY, "box"), other = mj_name2id(s.model.get(), mjOBJ_BODY, "other");
  bool slept = false;
  for (int n = 0; n < 1500; ++n) {
    s.data->mocap_pos[0] = 0.005 * std::sin(0.005 * n);
    s.step();
    ASSERT_GT(s.sensor().reading().values[0], 0);
    ASSERT_EQ(s.data->body_awake[box], mjS_AWAKE) << "step " << n;
    slept = slept || s.data->body_awake[other] == mjS_ASLEEP;
  }
  EXPECT_TRUE(slept) << "without a touch a box at rest falls asleep";
  EXPECT_LT(s.data->qfrc_passive[2], -0.01) << "the box feels the sensor";
}

/// Two stacked boxes sleep as one island before the sensor comes down from above.
TEST(SleepingBodies, AreWokenTogetherByASensorFromAbove) {
  SensorScene s;
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  s.compile("<mujoco><option timestep='0.001'><flag sleep='enable'/></option>" +
            sensor_extension("ball", key("others", "upper")) +
            R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='2 2 1'/>
      <body name='hand' mocap='true' pos='0 0 0.2'><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body>
      <body name='lower' pos='0 0 0.02'><freejoint/><geom type='box' size='0.05 0.05 0.02' mass='1'/></body>
      <body name='upper' pos='0 0 0.06'><freejoint/><geom name='upper' type='box' size='0.05 0.05 0.02' mass='1'/></body>
      </worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const int lower = mj_name2id(s.model.get(), mjOBJ_BODY, "lower"),
            upper = mj_name2id(s.model.get(), mjOBJ_BODY, "upper");
  s.step(2000);
  ASSERT_EQ(s.data->body_awake[lower], mjS_ASLEEP);
  ASSERT_EQ(s.data->body_awake[upper], mjS_ASLEEP);
  s.data->mocap_pos[2] = 0.099;
  s.step(2);
  ASSERT_GT(s.sensor().reading().values[0], 0);
  EXPECT_EQ(s.data->body_awake[upper], mjS_AWAKE);
  EXPECT_EQ(s.data->body_awake[lower], mjS_AWAKE) << "it slept with the other";
  EXPECT_LT(s.data->qfrc_passive[8], -0.01) << "the upper box feels the sensor";
  s.data->mocap_pos[2] = 0.2;
  s.step(2000);
  EXPECT_EQ(s.data->body_awake[upper], mjS_ASLEEP) << "left alone, it falls asleep again";
}

TEST(SeveralSensors, ReadTheirOwnContactsAndTheFirstAppliesAllForces) {
  SensorScene s;
  for (const char* name : {"a", "b"}) s.add_sensor(name, make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  s.compile(R"(<mujoco><extension><plugin plugin="taxel.sensor">
      <instance name="a"><config key="layout" value="a.taxels.json"/><config key="geom" value="a"/><config key="others" value="floor"/></instance>
      <instance name="b"><config key="layout" value="b.taxels.json"/><config key="geom" value="b"/><config key="others" value="floor"/></instance>
      </plugin></extension><default><geom contype='0' conaffinity='0'/></default>
      <asset><mesh name='a' file='a.obj'/><mesh name='b' file='b.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1'/>
      <body pos='0 0 0.0185'><freejoint/><geom name='a' type='mesh' mesh='a'/></body>
      <body pos='1 0 0.019'><freejoint/><geom name='b' type='mesh' mesh='b'/></body></worldbody>
      <sensor><plugin name='b taxels' plugin='taxel.sensor' instance='b'/>
      <plugin name='a taxels' plugin='taxel.sensor' instance='a'/></sensor></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  s.step();
  EXPECT_GT(s.data->sensordata[1], s.data->sensordata[0]);  // body a is deeper; b's sensor is listed first
  EXPECT_EQ(s.data->sensordata[1], s.sensor(0).reading().values[0]);
  EXPECT_EQ(s.data->sensordata[0], s.sensor(1).reading().values[0]);
  EXPECT_GT(s.data->qfrc_passive[2], s.data->qfrc_passive[8]);
  EXPECT_GT(s.data->qfrc_passive[8], 0);
}

}  // namespace
}  // namespace taxel
