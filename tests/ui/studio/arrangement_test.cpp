// The arrangement of panels: the share of the view, tabs where text is large, one arrangement for each mode, and a
// panel that fills the window.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kToSimulate = key("2", kCtrl);

double share(const Json& state) {
  return state["window"]["view_share"];
}
Json view_rect(const Json& state) {
  return state["view"]["rect"];
}
/// Returns the rectangle of a widget, or null.
Json rect_of(const Json& state, const std::string& panel, const std::string& label) {
  for (const Json& widget : state["widgets"])
    if (widget["panel"] == panel && widget["label"] == label) return widget["rect"];
  return nullptr;
}
bool has_tab(const Json& state, const std::string& title) {
  return !rect_of(state, "", title + " tab").is_null();
}
/// Returns the height of the axis of the pressure bars, in heights of text at scale 1, or 0 if no bars are shown.
double bars_height(const Json& state) {
  const Json& bars = state["bars"];
  return bars.empty() ? 0.0 : bars[0]["axis_height"].get<double>() / 15;
}

class WindowSize : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Sizes, WindowSize, testing::Values("1280x800", "1600x1000", "1920x1080"));

TEST_P(WindowSize, LeavesTheViewMoreThanHalfOfTheWindowInBothModes) {
  const StudioProgram studio;
  studio.play({kIdle, dump("simulate.json"), kLayoutMode, kIdle, dump("layout.json"), key("x"), kIdle,
               dump("probe.json"), key("Escape"), kIdle, kIdle, dump("left.json")},
              {"--size", GetParam(), kLayoutFile});
  const Json simulate = studio.state("simulate.json"), layout = studio.state("layout.json");
  const Json probe = studio.state("probe.json");
  EXPECT_GE(share(simulate), 0.55);
  EXPECT_GE(share(layout), 0.65);
  EXPECT_GE(share(probe), 0.55);
  EXPECT_GT(bars_height(simulate), 2.4) << "the bars are still readable";
  for (const char* tab : {"Pressure bars", "Taxels over travel", "Section"}) {
    EXPECT_TRUE(has_tab(simulate, tab)) << tab;
    EXPECT_FALSE(has_tab(layout, tab)) << tab << " has nothing to display without a probe";
    EXPECT_TRUE(has_tab(probe, tab)) << tab;
  }
  EXPECT_EQ(view_rect(studio.state("left.json")), view_rect(layout));
  EXPECT_TRUE(rect_of(layout, "Timeline", "Replay").is_null());
  EXPECT_LE(rect_of(simulate, "Timeline", "Replay")[3].get<double>() -
                rect_of(simulate, "Timeline", "Replay")[1].get<double>(),
            24)
      << "one line";
}

TEST(Arrangement, CutsNothingOffInToolbarAndTimeline) {
  const StudioProgram studio;
  const auto widths = [&](const std::string& size) {
    studio.play({kIdle, dump("state.json")}, {"--size", size, kLayoutFile});
    std::map<std::string, double> of;
    const Json state = studio.state("state.json");
    for (const Json& w : state["widgets"])
      if ((w["panel"] == "Toolbar" || w["panel"] == "Timeline") && w["label"] != "Timeline lanes" &&
          w["label"] != "Displayed step")
        of[w["label"]] = w["rect"][2].get<double>() - w["rect"][0].get<double>();
    return of;
  };
  const auto wide = widths("1920x1080");
  EXPECT_GT(wide.size(), 20U);
  EXPECT_EQ(widths("1280x800"), wide);
  EXPECT_EQ(widths("800x600"), wide);
}

TEST(Arrangement, StaysUsableInASmallWindow) {
  const StudioProgram studio;
  studio.play({kIdle, dump("simulate.json"), R"({"do": "screenshot", "file": "simulate.png"})", press("Tracks"), kIdle,
               dump("tracks.json"), press("Tracks"), kLayoutMode, kIdle, dump("layout.json")},
              {"--size", "800x600", kLayoutFile});
  const Json simulate = studio.state("simulate.json"), layout = studio.state("layout.json");
  EXPECT_GT(share(simulate), 0.35);
  EXPECT_GT(share(layout), 0.5);
  EXPECT_GT(bars_height(simulate), 1.9);
  const Json lanes = studio.state("tracks.json")["timeline"]["lanes"];
  EXPECT_GT(lanes[3].get<double>() - lanes[1].get<double>(), 90);
  EXPECT_GT(share(studio.state("tracks.json")), 0.15);
}

TEST(Arrangement, TurnsPanelsIntoTabsIfTextIsTooLargeAndBack) {
  const StudioProgram studio;
  Lines script{kIdle, dump("once.json")};
  for (int i = 0; i < 7; ++i) script.insert(script.end(), {key("=", kCtrl), kIdle});
  script.insert(script.end(), {dump("twice.json"), key("0", kCtrl), kIdle, dump("again.json")});
  studio.play(script);
  const Json once = studio.state("once.json"), twice = studio.state("twice.json"), again = studio.state("again.json");
  EXPECT_GT(bars_height(once), 2.4);
  EXPECT_GT(bars_height(twice), 2) << "in pixels of the larger text";
  const auto tab_row = [](const Json& state, const std::string& title) {
    return rect_of(state, "", title + " tab")[1];
  };
  EXPECT_NE(tab_row(once, "Taxels"), tab_row(once, "Inspector"));
  EXPECT_EQ(tab_row(twice, "Taxels"), tab_row(twice, "Inspector"));
  for (std::size_t side = 0; side < 4; ++side)
    EXPECT_NEAR(view_rect(again)[side].get<double>(), view_rect(once)[side].get<double>(), 1) << "but for rounding";
}

/// Drags the border between the view and the panels at its right.
Lines widen_the_column() {
  return {R"({"event": "mouse_move", "at": {"view": [1.0008, 0.5]}})",
          kIdle,
          R"({"event": "mouse_down", "at": {"view": [1.0008, 0.5]}})",
          kIdle,
          R"({"event": "mouse_move", "at": {"view": [0.8, 0.5]}})",
          kIdle,
          R"({"event": "mouse_up"})",
          kIdle};
}

TEST(Arrangement, IsKeptForEachModeAndFromStartToStart) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  // Files of an earlier version: its settings are read; its arrangement, one for both modes, is left alone.
  write_text(studio.folder() / "state/settings.json", R"({"panel_section": false, "dark": false})");
  write_text(studio.folder() / "state/window.ini", "[Docking][Data]\nDockSpace ID=0x00000001 Pos=0,0 Size=9,9\n");
  const std::vector<std::string> arguments{"--state-dir", "state", kLayoutFile};
  studio.play(joined({{kIdle, dump("simulate.json"), kLayoutMode, kIdle, dump("layout.json")},
                      widen_the_column(),
                      {dump("wider.json"), kToSimulate, kIdle, dump("simulate_again.json"), kLayoutMode, kIdle,
                       dump("layout_again.json")}}),
              arguments);
  const Json simulate = studio.state("simulate.json"), wider = studio.state("wider.json");
  EXPECT_TRUE(simulate["messages"].empty()) << simulate["messages"];
  EXPECT_GE(share(simulate), 0.55);
  EXPECT_FALSE(has_tab(simulate, "Section")) << "as the settings of the earlier version say";
  EXPECT_LT(view_rect(wider)[2], view_rect(studio.state("layout.json"))[2].get<double>() - 100);
  EXPECT_EQ(view_rect(studio.state("simulate_again.json")), view_rect(simulate));
  EXPECT_EQ(view_rect(studio.state("layout_again.json")), view_rect(wider));
  studio.play({kIdle, dump("simulate.json"), kLayoutMode, kIdle, dump("layout.json"), press("/View"), kIdle,
               press("View/Window"), kIdle, press("Reset arrangement"), kIdle, kIdle, dump("reset.json")},
              arguments);
  EXPECT_EQ(view_rect(studio.state("simulate.json")), view_rect(simulate));
  EXPECT_EQ(view_rect(studio.state("layout.json")), view_rect(wider));
  EXPECT_GE(share(studio.state("reset.json")), 0.65);
}

TEST(Arrangement, FillsTheWindowWithThePanelUnderTheMouse) {
  const StudioProgram studio;
  const std::string maximise = key("Space", kCtrl);
  studio.play({kIdle,
               dump("before.json"),
               R"({"event": "mouse_move", "at": {"view": [0.3, 0.3]}})",
               kIdle,
               maximise,
               kIdle,
               dump("view.json"),
               R"({"do": "screenshot", "file": "view.png"})",
               maximise,
               kIdle,
               dump("restored.json"),
               R"({"event": "mouse_move", "at": {"widget": "Bars"}})",
               kIdle,
               maximise,
               kIdle,
               dump("bars.json"),
               R"({"do": "screenshot", "file": "bars.png"})",
               kLayoutMode,
               kIdle,
               dump("layout.json"),
               kToSimulate,
               kIdle,
               dump("again.json")},
              {kLayoutFile});
  const Json before = studio.state("before.json"), bars = studio.state("bars.json");
  EXPECT_TRUE(before["window"]["maximised"].is_null());
  EXPECT_EQ(studio.state("view.json")["window"]["maximised"], "View");
  EXPECT_GT(share(studio.state("view.json")), 0.85);
  EXPECT_EQ(view_rect(studio.state("restored.json")), view_rect(before));
  EXPECT_TRUE(has_tab(studio.state("restored.json"), "Inspector"));
  EXPECT_EQ(bars["window"]["maximised"], "Pressure bars");
  EXPECT_EQ(share(bars), 0);
  EXPECT_GT(bars_height(bars), 4 * bars_height(before));
  EXPECT_GE(share(studio.state("layout.json")), 0.65) << "the other mode has its own arrangement";
  EXPECT_EQ(view_rect(studio.state("again.json")), view_rect(before)) << "a change of mode restores the panels";
}

}  // namespace
}  // namespace taxel::test
