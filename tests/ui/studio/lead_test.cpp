// A scene in the window that tables and a keyframe of the command line lead.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

constexpr const char* kLedScene = R"(<mujoco><option gravity='0 0 0'/><worldbody>
  <body name='arm'><joint name='elbow' axis='0 1 0' damping='1'/>
    <geom type='capsule' fromto='0 0 0 0 0 .2' size='.02' mass='.1'/></body>
  <body name='lead' mocap='true' pos='-.2 0 0'><geom name='lead' type='box' size='.01 .01 .01'/></body></worldbody>
  <actuator><motor name='turn' joint='elbow' ctrlrange='0 2'/><motor name='other' joint='elbow'/></actuator>
  <keyframe><key name='bent' qpos='.5' ctrl='0 .25'/></keyframe></mujoco>)";

const Lines kLedFiles{"scene.xml", "--keyframe", "bent", "--ctrl", "turn.csv", "--mocap", "poses.csv"};

void write_led_scene(const StudioProgram& studio) {
  write_text(studio.folder() / "scene.xml", kLedScene);
  write_text(studio.folder() / "turn.csv", "time,turn\n0,0\n1,2\n");
  write_text(studio.folder() / "poses.csv", "time,x,y,z\n0,-0.2,0,0\n1,-0.2,0,0.5\n");
}

/// Expects the led values of the latest step, which is made at the time of the previous one.
void expect_led(const Json& state) {
  const double time = state["simulation"]["time"];
  EXPECT_NEAR(state["scene"]["actuators"][0]["value"].get<double>(), 2 * time, 1e-9);
  EXPECT_NEAR(state["scene"]["mocaps"][0]["position"][2].get<double>(), 0.5 * time, 1e-9);
  EXPECT_EQ(state["scene"]["actuators"][1]["value"], 0.25) << "no column leads the actuator";
}

TEST(LedScene, FollowsItsTablesAlsoFromARecordedStep) {
  const StudioProgram studio;
  write_led_scene(studio);
  studio.play({kIdle, wait_time(0.2), key("Space"), kIdle, dump("paused.json"), key("Left"), kIdle, key("Left"), kIdle,
               key("Space"), wait_time(0.4), key("Space"), kIdle, dump("later.json"), key("Backspace"), kIdle,
               dump("reset.json")},
              kLedFiles);
  const Json paused = studio.state("paused.json"), later = studio.state("later.json");
  EXPECT_GT(paused["simulation"]["time"].get<double>(), 0.15);
  EXPECT_GT(later["simulation"]["time"].get<double>(), 0.35);
  expect_led(paused);
  expect_led(later);
  EXPECT_EQ(studio.state("reset.json")["scene"]["mocaps"][0]["position"][2], 0);
}

TEST(LedScene, SaysWhyATableDoesNotFit) {
  const StudioProgram studio;
  write_led_scene(studio);
  write_text(studio.folder() / "turn.csv", "time,trun\n0,0\n1,2\n");
  const Outcome outcome = studio.run({kIdle, dump("refused.json")}, kLedFiles);
  EXPECT_EQ(outcome.status, 2);
  const std::string why =
      "turn.csv: column \"trun\": names no actuator of the scene; there are \"turn\", \"other\"; did you mean "
      "\"turn\"?";
  EXPECT_EQ(outcome.err, "taxelstudio: " + why + "\n");
  EXPECT_EQ(studio.state("refused.json")["messages"][0]["text"], why) << "the message line says so, too";
}

TEST(LedScene, NeedsAFileThatIsLed) {
  const StudioProgram studio;
  const Outcome outcome = run_program(STUDIO_PROGRAM, {"--headless", "--ctrl", "turn.csv"}, studio.folder());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--ctrl"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace taxel::test
