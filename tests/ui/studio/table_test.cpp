// Tables and helper functions of the interface, without a window.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "app/studio/frame/app.h"
#include "app/studio/frame/command.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/shell/interface/carry_out.h"
#include "ui/widgets/format.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {
namespace {

TEST(Keymap, GivesEachKeyOneMeaningPerContext) {
  for (const Context context : {Context::layout, Context::simulate}) {
    std::map<int, std::string> seen;
    for (const Binding& b : bindings()) {
      if (b.chord == 0 || (b.context != Context::everywhere && b.context != context)) continue;
      EXPECT_TRUE(seen.emplace(b.chord, b.label).second)
          << chord_name(b.chord) << ": " << b.label << " and " << seen[b.chord];
    }
  }
}

TEST(Keymap, GivesEveryCommandOneReachableRow) {
  std::set<std::string> seen;
  for (const Binding& b : bindings()) {
    EXPECT_TRUE(seen.insert(std::string(b.menu != nullptr ? b.menu : "") + "/" + b.label).second) << b.label;
    EXPECT_TRUE(b.chord != 0 || b.menu != nullptr) << b.label;
    const auto first = std::find_if(bindings().begin(), bindings().end(),
                                    [&](const Binding& other) { return other.command == b.command; });
    EXPECT_EQ(&*first, &b) << b.label;
  }
}

TEST(Keymap, TogglesTheNamedValue) {
  int toggles = 0;
  for (const Binding& b : bindings()) {
    App app;
    const bool before = is_checked(b, app);
    carry_out_if_enabled(b, app);
    if (is_checked(b, app) == before) continue;
    ++toggles;
    carry_out_if_enabled(b, app);
    EXPECT_EQ(is_checked(b, app), before) << b.label;
  }
  EXPECT_GT(toggles, 0);
}

TEST(Speed, ChangesByFactorsOfTwoWithinItsLimits) {
  EXPECT_EQ(next_speed(1, true), 2);
  EXPECT_EQ(next_speed(1, false), 0.5);
  EXPECT_EQ(next_speed(16, true), 16);
  EXPECT_EQ(next_speed(1.0 / 16, false), 1.0 / 16);
}

TEST(Format, RoundsUpToTheNextNiceNumber) {
  EXPECT_EQ(nice_ceiling(1), 1);
  EXPECT_EQ(nice_ceiling(1.01), 1.5);
  EXPECT_EQ(nice_ceiling(8.1), 10);
  EXPECT_EQ(nice_ceiling(7490), 8000);
  EXPECT_EQ(nice_ceiling(0), 0);
  for (double value = 1e-6; value < 1e9; value *= 1.37) {
    EXPECT_GE(nice_ceiling(value), value);
    EXPECT_LE(nice_ceiling(value), 1.5 * value * (1 + 1e-12));
  }
}

TEST(Format, WritesNumbersInReadableUnits) {
  EXPECT_EQ(grouped(7), "7");
  EXPECT_EQ(grouped(1234), "1 234");
  EXPECT_EQ(grouped(-1234567), "-1 234 567");
  EXPECT_EQ(grouped(-123), "-123");
  EXPECT_EQ(number_in_unit(7523, {}), "7.52");
  EXPECT_EQ(number_in_unit(9996, {}), "10.0");
  EXPECT_EQ(number_in_unit(123456, {}), "123");
  EXPECT_EQ(in_unit(7523, shown_unit(Aggregate::max)), "7.52 kPa");
  EXPECT_EQ(in_unit(0.25, shown_unit(Aggregate::force)), "0.250 N");
  EXPECT_EQ(in_unit(0.025, shown_unit(Aggregate::weighted_sum)), "25.000 kPa mm\u00b2");
  EXPECT_EQ(in_mm(0.0061), "6.10 mm");
  EXPECT_EQ(duration_text(312.4e-6), "312 \u00b5s");
  EXPECT_EQ(duration_text(0.9996e-3), "1.00 ms");
  EXPECT_EQ(duration_text(0.01234), "12.34 ms");
}

TEST(Format, ShiftsDecimalsWithoutRoundingErrors) {
  EXPECT_EQ(shifted_decimal(4.2, -3), 0.0042);
  EXPECT_EQ(shifted_decimal(-6.5, -3), -0.0065);
  EXPECT_EQ(shifted_decimal(0.0042, 3), 4.2);
  EXPECT_EQ(shifted_decimal(1e-5, -3), 1e-8);
  EXPECT_EQ(shifted_decimal(1e22, 3), 1e25);
  EXPECT_EQ(shifted_decimal(0, -3), 0);
  EXPECT_EQ(shifted_decimal(7, 0), 7);
}

TEST(Status, ShowsTheSpeedOnlyWhileTheSimulationMoves) {
  App app;
  app.shown->run.playing = true;
  app.shown->run.performance.simulation_speed = 0.984;
  EXPECT_EQ(pace_text(*app.shown), "") << "no simulation";
  SimFrame frame;
  frame.scene = std::make_shared<const SimScene>();
  app.shown->run.frame = std::make_shared<const SimFrame>(frame);
  EXPECT_EQ(pace_text(*app.shown), "0.98 x real time");
  app.shown->run.performance.is_real_time = false;
  EXPECT_EQ(pace_text(*app.shown), "") << "a script sets the pace";
  app.shown->run.performance.is_real_time = true;
  app.shown->run.playing = false;
  EXPECT_EQ(pace_text(*app.shown), "paused");
  frame.finished = true;
  app.shown->run.frame = std::make_shared<const SimFrame>(frame);
  EXPECT_EQ(pace_text(*app.shown), "ended");
}

TEST(Widgets, FindTheTopmostOne) {
  WidgetRegistry widgets;
  widgets.note("Toolbar", "Run", {0, 0, 10, 10});
  widgets.note("Simulation", "Run", {20, 0, 30, 10});
  EXPECT_EQ(widgets.find("Run")->panel, "Simulation");
  EXPECT_EQ(widgets.find("Toolbar/Run")->rect.x1, 10);
  EXPECT_EQ(widgets.find("Toolbar/Walk"), nullptr);
  EXPECT_EQ(widgets.find("bar/Run"), nullptr);
  widgets.begin_frame();
  EXPECT_EQ(widgets.find("Run"), nullptr);
}

}  // namespace
}  // namespace taxel::ui
