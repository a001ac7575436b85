// Error bars in the window: whiskers on the pressure bars and in the plot, while the run is paused and while it plays.
#include <gtest/gtest.h>

#include <algorithm>

#include "script_lines.h"

namespace taxel::test {
namespace {

const Lines kInSweep{key("="), key("="), R"({"do": "wait_time", "time": 1.3})", key("Space"), kIdle};

double largest_error(const Json& state) {
  double largest = 0;
  for (const Json& bar : state["bars"]) largest = std::max(largest, bar["error"].get<double>());
  return largest;
}

TEST(ErrorBarsInTheWindow, AreDrawnOnBarsAndCurvesWhenSwitchedOn) {
  const StudioProgram studio;
  studio.play(joined({kInSweep,
                      {dump("off.json"),
                       press("Error bars"),
                       kIdle,
                       dump("on.json"),
                       R"({"do": "screenshot", "file": "on.png"})",
                       key("Right"),
                       kIdle,
                       dump("next.json"),
                       key("F4"),
                       kIdle,
                       key("F4"),
                       kIdle,
                       kIdle,
                       dump("plot.json"),
                       R"({"do": "screenshot", "file": "plot.png"})",
                       key("F4"),
                       kIdle,
                       press("Error bars"),
                       kIdle,
                       dump("off_again.json")}}),
              sparse_fingertip(studio, 1e6, "1600x1000"));
  const Json on = studio.state("on.json");
  EXPECT_EQ(largest_error(studio.state("off.json")), 0);
  double peak = 0;
  for (const Json& bar : on["bars"]) peak = std::max(peak, bar["value"].get<double>());
  EXPECT_GT(largest_error(on), 1e-4 * peak);
  EXPECT_LT(largest_error(on), 0.1 * peak);
  EXPECT_GE(studio.state("plot.json")["plot"]["errors"], 2);
  const Json next = studio.state("next.json");
  EXPECT_EQ(next["simulation"]["step"].get<int>(), on["simulation"]["step"].get<int>() + 1);
  EXPECT_GT(largest_error(next), 0);
  EXPECT_EQ(largest_error(studio.state("off_again.json")), 0);
}

TEST(ErrorBarsInTheWindow, AreInRecordingsWhileSwitchedOn) {
  const StudioProgram studio;
  studio.play(joined({kInSweep,
                      {press("Error bars"), kIdle, press("Record"), kIdle, key("Right"), kIdle, key("Right"), kIdle,
                       dump("state.json"), press("Record"), kIdle, press("Error bars"), kIdle, press("Record"), kIdle,
                       key("Right"), kIdle, press("Record"), kIdle}}),
              sparse_fingertip(studio, 1e6, "1600x1000"));
  const std::string with = file_text(studio.folder() / "recording-1/readings.csv");
  const std::string without = file_text(studio.folder() / "recording-2/readings.csv");
  EXPECT_NE(with.find(",taxel_11,taxel_0_error,taxel_1_error,"), std::string::npos) << with.substr(0, 300);
  EXPECT_EQ(without.find("_error"), std::string::npos);
  double drawn = 0;
  const Json state = studio.state("state.json");
  for (const Json& bar : state["bars"]) drawn = std::max(drawn, bar["error"].get<double>());
  EXPECT_NE(with.find(Json(drawn).dump()), std::string::npos) << drawn << ": the bars that the window draws";
}

TEST(ErrorBarsInTheWindow, StayWithinOnePercentWhenAsked) {
  const StudioProgram studio;
  Lines lines = joined({kInSweep, {press("Error bars"), kIdle, dump("before.json"), press("Within 1 %")}});
  for (int i = 0; i < 12; ++i) lines.push_back(kIdle);
  lines.push_back(dump("after.json"));
  lines.emplace_back(R"({"do": "screenshot", "file": "within.png"})");
  studio.play(lines, sparse_fingertip(studio, 1e6, "1600x1000"));
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  double peak = 0;
  for (const Json& bar : after["bars"]) peak = std::max(peak, bar["value"].get<double>());
  EXPECT_GT(largest_error(before), 0.02 * peak);
  EXPECT_LE(largest_error(after), 0.0101 * peak);
  const Json& layout = after["document"]["layout"];
  EXPECT_EQ(layout["sampling"], before["document"]["layout"]["sampling"]) << "only taxels get more samples";
  int dense = 0;
  for (const Json& taxel : layout["taxels"]) dense += taxel.value("density", 0.0) > 2e6 ? 1 : 0;
  EXPECT_GE(dense, 1);
  EXPECT_LE(dense, 6) << "the other side of the finger touches nothing";
}

}  // namespace
}  // namespace taxel::test
