// The demo at the start: its camera, its loop over the whole run, and its end at the first input.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string until(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}

std::string wait_for(const std::string& pointer, const std::string& condition) {
  return R"({"do": "wait_for", "pointer": ")" + pointer + R"(", )" + condition + "}";
}

/// The sweep of the window's start, over an edge.
const std::vector<std::string> kEdge{"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"};
const std::vector<std::string> kDemo{"--demo", kEdge[0], kEdge[1]};

double azimuth(const Json& state) {
  return state["camera"]["azimuth_deg"].get<double>();
}

TEST(Demo, SwaysTheCameraAroundTheContactAndComesCloser) {
  const StudioProgram studio;
  studio.play({kIdle, until(1), dump("first.json"), until(2.6), dump("early.json"), until(4.4), dump("late.json")},
              kDemo);
  const Json first = studio.state("first.json"), early = studio.state("early.json"), late = studio.state("late.json");
  EXPECT_TRUE(early["simulation"]["history"]["demo"]["runs"]);
  EXPECT_GT(std::abs(azimuth(late) - azimuth(early)), 5);
  EXPECT_LT(late["camera"]["distance"].get<double>(), 0.95 * first["camera"]["distance"].get<double>());
  EXPECT_TRUE(late["sensor_boxes"][0]["inside"]) << "the finger stays in the picture";
}

TEST(Demo, KeepsItsWholeRunAndRepeatsIt) {
  const StudioProgram studio;
  studio.play({kIdle, until(4.9), wait_for("/simulation/history/demo/loops", R"("equals": true)"),
               wait_for("/simulation/time", R"("most": 1)"), dump("again.json")},
              kDemo);
  const Json history = studio.state("again.json")["simulation"]["history"];
  EXPECT_EQ(history["first"], 0);
  EXPECT_GT(history["last"], 4000);
  EXPECT_TRUE(history["recorded"]);
  EXPECT_EQ(history["loop"], Json::array({history["first"], history["last"]}));
  EXPECT_EQ(history["replay"], 1);
}

TEST(Demo, EndsAtTheFirstKeyAndNotWhenThePointerMoves) {
  const StudioProgram studio;
  studio.play({kIdle, until(3), R"({"event": "mouse_move", "at": [300, 300]})", until(3.1), dump("moved.json"),
               key("H"), until(3.2), dump("typed.json"), until(3.5), dump("after.json")},
              kDemo);
  EXPECT_TRUE(studio.state("moved.json")["simulation"]["history"]["demo"]["runs"]);
  const Json typed = studio.state("typed.json"), after = studio.state("after.json");
  EXPECT_FALSE(typed["simulation"]["history"]["demo"]["runs"]);
  EXPECT_EQ(typed["camera"], after["camera"]) << "the camera rests";
  EXPECT_GT(after["simulation"]["time"], typed["simulation"]["time"]) << "the run goes on";
}

TEST(Demo, IsNotPlayedInAScriptUnlessItIsAskedFor) {
  const StudioProgram studio;
  studio.play({kIdle, until(3), dump("plain.json")}, kEdge);
  EXPECT_FALSE(studio.state("plain.json")["simulation"]["history"]["demo"]["runs"]);
}

TEST(Demo, IsRefusedForAFile) {
  const Outcome outcome = StudioProgram().run({}, {"--demo", kLayoutFile});
  EXPECT_EQ(outcome.status, 2);
}

}  // namespace
}  // namespace taxel::test
