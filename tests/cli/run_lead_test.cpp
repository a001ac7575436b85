// `taxel run` with a start keyframe, and with tables and recorded runs that lead the scene.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// A finger on a slide that an actuator lowers onto the floor, and a mocap plate above it. The skin is 2 mm above the
/// floor at the start.
constexpr const char* kScene = R"(<mujoco><option timestep="0.002" gravity="0 0 0"/>
  <asset><mesh name="tip" file="fingertip.obj"/></asset><worldbody>
  <geom name="floor" type="plane" size="1 1 0.1"/>
  <body name="finger" pos="0 0 0.0091" quat="0.70710678 0.70710678 0 0">
    <joint name="lift" type="slide" axis="0 1 0" damping="2"/><geom name="tip" type="mesh" mesh="tip"/></body>
  <body name="plate" mocap="true" pos="0 0 0.05"><geom name="plate" type="box" size="0.03 0.03 0.01"/></body>
  </worldbody>
  <actuator><position name="lower" joint="lift" kp="500" ctrlrange="-0.004 0.004"/></actuator>
  <keyframe><key name="clear" mpos="0 0 0.05"/><key name="pressed" qpos="-0.003" ctrl="-0.003" mpos="0 0 0.05"/></keyframe></mujoco>)";

class LedRun : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy(fs::path(TAXEL_SOURCE_DIR) / "assets" / "meshes" / "fingertip.obj", folder);
    changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "fingertip.obj"},
                                           {"op": "replace", "path": "/sampling/density", "value": 1e6}])"));
    write_text(folder / "scene.xml", kScene);
  }
  [[nodiscard]] Outcome run(std::vector<std::string> more) const {
    const std::vector<std::string> first{"run", "scene.xml", "--layout", "changed.taxels.json", "--geom", "tip"};
    more.insert(more.begin(), first.begin(), first.end());
    return taxel(more, folder);
  }
  /// Returns the readings of a run with these options.
  Table readings(std::vector<std::string> more, const std::string& out = "out") const {
    more.insert(more.end(), {"--out", out});
    const Outcome outcome = run(more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_csv(folder / out / "readings.csv");
  }
  fs::path folder = test_folder();
};

TEST_F(LedRun, StartsAtAKeyframe) {
  EXPECT_EQ(readings({"--seconds", "0.004"}).at("force_z").front(), 0);
  const double pressed = readings({"--seconds", "0.004", "--keyframe", "pressed"}).at("force_z").front();
  EXPECT_GT(pressed, 0.01);
  EXPECT_EQ(readings({"--seconds", "0.004", "--keyframe", "1"}).at("force_z").front(), pressed);
  expect_refusal(run({"--keyframe", "presed"}),
                 "taxel: scene.xml: has no keyframe \"presed\"; there are \"clear\", \"pressed\" (numbers 0 to 1); did "
                 "you mean \"pressed\"?");
}

TEST_F(LedRun, PressesTheSkinByATableOfControls) {
  write_text(folder / "ctrl.csv", "time,lower\n0,0\n0.1,-0.003\n0.2,-0.003\n0.3,0\n");
  const Table table = readings({"--ctrl", "ctrl.csv"});
  ASSERT_EQ(table.at("time").size(), 151U) << "the run ends with the last row of the table";
  EXPECT_NEAR(table.at("time").back(), 0.3, 1e-9);
  EXPECT_EQ(table.at("force_z").front(), 0);
  EXPECT_GT(table.at("force_z")[100], 0.01);
  EXPECT_GT(table.at("taxel_0")[100], 0);
  EXPECT_EQ(table.at("force_z").back(), 0);
  EXPECT_EQ(readings({"--ctrl", "ctrl.csv", "--seconds", "0.02"}).at("time").size(), 10U);
  // The values of the keyframe hold where no column leads, and the table leads from its first row.
  write_text(folder / "back.csv", "time,lower\n0.05,-0.003\n0.06,-0.003\n");
  EXPECT_GT(readings({"--ctrl", "back.csv"}).at("force_z").back(), 0.01);
  write_text(folder / "far.csv", "time,lower\n0,0\n0.1,-0.005\n");
  const std::string limited =
      "actuator \"lower\": 1 of 2 values are outside of its range, -0.004 to 0.004, and are clamped: the first is "
      "-0.005 "
      "in line 3";
  EXPECT_NE(run({"--ctrl", "far.csv"}).err.find(limited), std::string::npos);
}

TEST_F(LedRun, PressesTheSkinByATableOfPosesAndRepeatsTheRun) {
  // The back of the finger is at 17.5 mm, and the plate is pressed 1 mm into it. The actuator holds the finger.
  write_text(folder / "poses.csv", "t,plate_x,plate_y,plate_z\n0,0,0,0.03\n0.1,0,0,0.0265\n0.15,0,0,0.0265\n");
  const Table table = readings({"--mocap", "poses.csv"});
  EXPECT_NE(run({"--mocap", "poses.csv"}).out.find(", deflection from the mocap body up to "), std::string::npos);
  EXPECT_EQ(table.at("force_z").front(), 0);
  EXPECT_LT(table.at("force_z").back(), -0.01);
  EXPECT_EQ(table.at("travel").front(), 0) << "the travel begins at the first row";
  EXPECT_NEAR(table.at("travel").back(), 0.0035, 1e-12);
  readings({"--replay", "out", "--keyframe", "0"}, "again");
  const Json written = Json::parse(file_text(folder / "again" / "sweep.json"));
  EXPECT_EQ(written["replay"], "out");
  EXPECT_EQ(written["keyframe"], "0");
  EXPECT_FALSE(written.contains("mocap"));
  EXPECT_EQ(file_text(folder / "out" / "readings.csv"), file_text(folder / "again" / "readings.csv"));
  EXPECT_EQ(readings({"--replay", "again/readings.npz"}, "third"), table);
}

TEST_F(LedRun, RefusesTablesThatDoNotFitTheScene) {
  write_text(folder / "ctrl.csv", "time,lift\n0,0\n1,1\n");
  expect_refusal(run({"--ctrl", "ctrl.csv"}),
                 "taxel: ctrl.csv: column \"lift\": names no actuator of the scene; there are \"lower\"");
  write_text(folder / "poses.csv", "time,plate_x,plate_y,plate_z\n0,0,0,0.03\n0.1,0,,0.03\n");
  expect_refusal(run({"--mocap", "poses.csv"}),
                 "taxel: poses.csv: line 3, column \"plate_y\": the value is missing: every row needs all values");
  expect_refusal(run({"--mocap", "none.csv"}), "taxel: none.csv: no such file");
  expect_refusal(run({"--mocap", "poses.csv", "--replay", "out"}), "taxel: run: --mocap excludes --replay");
  expect_refusal(run({"--replay", "out"}), "taxel: out: no such file");
}

}  // namespace
}  // namespace taxel::test
