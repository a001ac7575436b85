// The arrangement of panels: side by side, or as tabs if the text is too large.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns the height of the axis of the pressure bars, in heights of text at scale 1, or 0 if no bars are shown.
double bars_height(const Json& state) {
  const Json& bars = state["bars"];
  return bars.empty() ? 0.0 : bars[0]["axis_height"].get<double>() / 15;
}

TEST(Arrangement, TurnsPanelsIntoTabsIfTextIsTooLargeAndBack) {
  const StudioProgram studio;
  Lines script{kLayoutMode, kIdle, dump("once.json")};
  for (int i = 0; i < 7; ++i) script.insert(script.end(), {key("=", kCtrl), kIdle});
  script.insert(script.end(), {dump("twice.json"), key("0", kCtrl), kIdle, dump("again.json")});
  studio.play(script);
  const Json once = studio.state("once.json"), twice = studio.state("twice.json"), again = studio.state("again.json");
  const auto rect = [](const Json& state) { return state["view"]["rect"]; };
  EXPECT_GT(bars_height(once), 4);
  EXPECT_GT(bars_height(twice), 2.5) << "side by side there would be no room for them";
  EXPECT_LT(rect(twice)[2].get<double>() - rect(twice)[0].get<double>(),
            rect(once)[2].get<double>() - rect(once)[0].get<double>() - 50);
  EXPECT_EQ(rect(again), rect(once));
}

}  // namespace
}  // namespace taxel::test
