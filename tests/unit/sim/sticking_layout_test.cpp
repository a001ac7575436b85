// Friction that sticks by the material of a layout: in scenes of users, in scenarios and for attached layouts.
#include <gtest/gtest.h>

#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/sensor_scene.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

constexpr double kStiffness = 1e7;
constexpr int kBristles = 300;

/// A soft block with a taxel on a slope, and its scene with further keys of the plugin.
struct LayoutSlope {
  SensorScene s;
  explicit LayoutSlope(double stiffness) {
    Material material{FieldKind::pad, 2e4, 0.005, 20, 0.5, FaceRule::along_gradient, stiffness, kBristles};
    s.add_sensor("block", make_box({0.03, 0.03, 0.015}), material);
  }
  [[nodiscard]] static std::string scene(const std::string& sensor) {
    return "<mujoco><option gravity='2.5 0 -9.5'/>" + sensor +
           R"(<asset><mesh name='block' file='block.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
      <body pos='0 0 0.0149'><freejoint/><inertial mass='0.1' pos='0 0 -0.014' diaginertia='3.7e-5 3.7e-5 6e-5'/>
        <geom name='block' type='mesh' mesh='block' contype='0' conaffinity='0'/></body></worldbody></mujoco>)";
  }
  void compile(const std::string& keys) {
    s.compile(scene(sensor_extension("block", key("others", "floor") + keys)));
    if (s.model == nullptr) throw Error(s.error);
  }
};

SensorModelPtr sticking_fingertip(double stiffness) {
  return test::fingertip_model(1e5, stiffness, kBristles);
}

TEST(StickingLayout, SticksAsByTheKeysOfThePlugin) {
  LayoutSlope by_layout(kStiffness), by_keys(0);
  by_layout.compile(key("output", "readings wrench slip"));
  by_keys.compile(key("output", "readings wrench slip") + key("tangential_stiffness", "1e7") +
                  key("bristles", std::to_string(kBristles)));
  EXPECT_EQ(by_layout.s.model->npluginstate, by_keys.s.model->npluginstate);
  ASSERT_EQ(by_layout.s.model->nsensordata, 8);
  for (int n = 0; n < 300; ++n) {
    by_layout.s.step();
    by_keys.s.step();
    for (int i = 0; i < 8; ++i) ASSERT_EQ(by_layout.s.data->sensordata[i], by_keys.s.data->sensordata[i]) << n;
  }
  EXPECT_LT(std::abs(by_layout.s.data->qvel[0]), 1e-5);
  EXPECT_GT(by_layout.s.data->sensordata[1], -0.26);
  EXPECT_LT(by_layout.s.data->sensordata[1], -0.24);
}

TEST(StickingLayout, CountsLessThanTheKeysOfThePlugin) {
  LayoutSlope slope(kStiffness);
  slope.compile(key("tangential_stiffness", "0"));
  EXPECT_LT(slope.s.model->npluginstate, 5 * kBristles);
  slope.compile(key("tangential_stiffness", "1e6") + key("bristles", "600"));
  EXPECT_GT(slope.s.model->npluginstate, 5 * 600);
  slope.s.compile(LayoutSlope::scene(
      sensor_extension("block", key("others", "floor") + key("tangential_stiffness", "0") + key("output", "slip"))));
  EXPECT_EQ(slope.s.model, nullptr);
  EXPECT_NE(slope.s.error.find("or in the layout's material"), std::string::npos) << slope.s.error;
}

TEST(StickingLayout, SticksWhereItIsAttached) {
  for (const double stiffness : {0.0, kStiffness}) {
    LayoutSlope slope(stiffness);
    std::string scene = LayoutSlope::scene("");  // a floor that the block, which is only drawn, can touch
    const std::string bits = " contype='0' conaffinity='0'";
    write_file_atomically(slope.s.folder / "bare.xml", scene.erase(scene.find(bits), bits.size()));
    const auto simulator =
        Simulator::load(slope.s.folder / "bare.xml", {{"block", (slope.s.folder / "block.taxels.json").string()}});
    for (int n = 0; n < 300; ++n) simulator->step();
    const StepView now = simulator->view();
    ASSERT_EQ(now.sensors.size(), 1U);
    EXPECT_EQ(now.scene->sensor_slips.at(0), stiffness > 0);
    EXPECT_EQ(now.sensors[0].slip.size(), stiffness > 0 ? 1U : 0U);
    export_scene(*simulator, slope.s.folder / "moved");
    const auto moved = Simulator::load(slope.s.folder / "moved/scene.xml");
    for (int n = 0; n < 300; ++n) moved->step();
    EXPECT_EQ(moved->view().sensors.at(0).force_W, now.sensors[0].force_W);
  }
}

TEST(StickingLayout, SticksInAScenarioAndInItsSavedScene) {
  const auto sweep = Simulator::make_scenario(sticking_fingertip(1.5e8), test::box_sweep());
  EXPECT_TRUE(sweep->scene()->sensor_slips.at(0));
  SensorScene room;
  export_scene(*sweep, room.folder / "saved");
  const auto saved = Simulator::load(room.folder / "saved/scene.xml");
  EXPECT_TRUE(saved->scene()->sensor_slips.at(0));
  double most = 0;
  for (int n = 0; n < 1700; ++n) {
    sweep->step();
    const StepView step = sweep->view();
    for (const double slip : step.sensors.at(0).slip) most = std::max(most, slip);
  }
  ASSERT_FALSE(sweep->view().sensors[0].surfaces.empty());
  EXPECT_EQ(sweep->view().sensors[0].slip.size(), sweep->view().sensors[0].readings.size());
  EXPECT_GT(most, 0.5);
  EXPECT_LE(most, 1);
}

TEST(StickingLayout, NeedsAnotherRunWhereFrictionChanges) {
  const SensorModelPtr before = sticking_fingertip(1.5e8);
  const auto simulator = Simulator::make_scenario(before, test::box_sweep());
  EXPECT_THROW(simulator->replace_model(before, sticking_fingertip(0)), Error);
  EXPECT_EQ(simulator->scene()->sensors.at(0), before);
  EXPECT_NO_THROW(simulator->replace_model(before, sticking_fingertip(1.5e8)));
}

}  // namespace
}  // namespace taxel
