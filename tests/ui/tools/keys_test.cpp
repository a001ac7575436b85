// Keys and commands: the command that each key posts, and the limits of scales and speeds.
#include <gtest/gtest.h>

#include <algorithm>

#include <fstream>
#include <sstream>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/timeline/timeline.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/interface/carry_out.h"
#include "ui/theme.h"
#include "ui/tools/running.h"

namespace taxel::ui {
namespace {

/// The table of keys is written down twice on purpose: a key that changes by mistake differs from bindings.txt. After
/// an intended change, run `taxelstudio --list-bindings > tests/ui/tools/bindings.txt`.
TEST(Keys, EqualTheListInTheTests) {
  std::ifstream file(TAXEL_SOURCE_DIR "/tests/ui/tools/bindings.txt");
  std::stringstream expected;
  expected << file.rdbuf();
  EXPECT_EQ(bindings_as_text(), expected.str());
}

using test::Running;

TEST(Keys, MoveThroughTimeInTheRightDirection) {
  Running run;
  ASSERT_NE(run.pressed<SetSpeed>(ImGuiKey_Equal), nullptr);
  EXPECT_EQ(run.scene.asked<SetSpeed>()->factor, 2);
  ASSERT_NE(run.pressed<SetSpeed>(ImGuiKey_Minus), nullptr);
  EXPECT_EQ(run.scene.asked<SetSpeed>()->factor, 0.5);
  ASSERT_NE(run.pressed<ScrubTo>(ImGuiKey_RightArrow, ImGuiMod_Shift), nullptr);
  EXPECT_EQ(run.scene.asked<ScrubTo>()->step, 17U);
  ASSERT_NE(run.pressed<ScrubTo>(ImGuiKey_LeftArrow, ImGuiMod_Shift), nullptr);
  EXPECT_EQ(run.scene.asked<ScrubTo>()->step, 12U);
  ASSERT_NE(run.pressed<ScrubTo>(ImGuiKey_End), nullptr);
  EXPECT_EQ(run.scene.asked<ScrubTo>()->step, 20U);
  ASSERT_NE(run.pressed<ReplayHistory>(ImGuiKey_Space, ImGuiMod_Shift), nullptr);
  EXPECT_EQ(run.scene.asked<ReplayHistory>()->direction, -1);
  run.scene.app.shown->run.replay = -1;
  ASSERT_NE(run.pressed<ReplayHistory>(ImGuiKey_Space, ImGuiMod_Shift), nullptr);
  EXPECT_EQ(run.scene.asked<ReplayHistory>()->direction, 0) << "once more: it stops";
  EXPECT_NE(run.pressed<StepBack>(ImGuiKey_LeftArrow), nullptr);
  EXPECT_NE(run.pressed<StepOnce>(ImGuiKey_RightArrow), nullptr);
  EXPECT_NE(run.pressed<PlayOrPause>(ImGuiKey_Space), nullptr);
  EXPECT_NE(run.pressed<ResetSimulation>(ImGuiKey_Backspace), nullptr);
}

TEST(Overlays, ToggleTheValueOfTheirRow) {
  Running run;
  const Overlays before = run.scene.app.viewer->overlays();
  for (const OverlaySpec& row : overlays()) {
    carry_out_if_enabled(ToggleOverlay{row.on}, run.scene.app);
    Overlays expected = before;
    expected.*row.on = !(before.*row.on);
    EXPECT_EQ(run.scene.app.viewer->overlays(), expected) << row.label;
    EXPECT_EQ(is_checked(binding_of(ToggleOverlay{row.on}), run.scene.app), expected.*row.on);
    run.scene.app.viewer->overlays() = before;
  }
}

TEST(Overlays, ToggleTheValueOfTheirGroup) {
  Running run;
  Overlays& shown = run.scene.app.viewer->overlays();
  for (GroupsShown Overlays::*groups : {&Overlays::geom_groups, &Overlays::site_groups}) {
    for (std::size_t i = 0; i < kSceneGroups; ++i) {
      GroupsShown expected = shown.*groups;
      expected.at(i) = !expected.at(i);
      carry_out_if_enabled(ToggleGroup{groups, i}, run.scene.app);
      EXPECT_EQ(shown.*groups, expected) << i;
    }
  }
}

TEST(Panels, OpenAndCloseByTheirRows) {
  Running run;
  for (const Feature* row : features()) {
    if (row->opens == Opens::never) continue;
    bool& shown = run.scene.app.get<PanelsShown>()[*row];
    const bool before = shown;
    carry_out_if_enabled(TogglePanel{row}, run.scene.app);
    EXPECT_NE(shown, before) << row->title;
    EXPECT_EQ(std::ranges::count(run.scene.app.ui->opened, &shown), shown ? 1 : 0) << row->title;
  }
}

TEST(Loop, CoversAllRecordedStepsOrNone) {
  Running run;
  carry_out_if_enabled(ToggleLoop{}, run.scene.app);
  EXPECT_EQ(run.scene.asked<SetLoop>()->range, (StepRange{10, 20}));
  run.scene.app.shown->run.loop = StepRange{10, 20};
  carry_out_if_enabled(ToggleLoop{}, run.scene.app);
  EXPECT_EQ(run.scene.asked<SetLoop>()->range, std::nullopt);
}

TEST(Interface, ScalesWithinItsLimits) {
  Running run;
  Appearance& saved = run.scene.app.get<Appearance>();
  carry_out_if_enabled(ScaleInterface{1}, run.scene.app);
  EXPECT_FLOAT_EQ(saved.scale, 1.1f);
  for (int i = 0; i < 40; ++i) carry_out_if_enabled(ScaleInterface{1}, run.scene.app);
  EXPECT_FLOAT_EQ(saved.scale, 2.5f);
  for (int i = 0; i < 80; ++i) carry_out_if_enabled(ScaleInterface{-1}, run.scene.app);
  EXPECT_FLOAT_EQ(saved.scale, 0.6f);
  carry_out_if_enabled(ScaleInterface{0}, run.scene.app);
  EXPECT_EQ(saved.scale, 1);
}

TEST(SelectionOfTaxels, KeepsTheActiveOneLast) {
  Running run;
  App& app = run.scene.app;
  click_taxel(app.viewer->selection, 2, false);
  click_taxel(app.viewer->selection, 1, true);
  EXPECT_EQ(app.viewer->selection.taxels, (std::vector<int>{2, 1})) << "Shift adds";
  click_taxel(app.viewer->selection, 2, true);
  EXPECT_EQ(app.viewer->selection.taxels, (std::vector<int>{1})) << "Shift takes out";
  app.viewer->selection.set_all(run.scene.project.layout);
  EXPECT_EQ(app.viewer->selection.taxels, (std::vector<int>{2, 1})) << "the active one stays active";
  click_taxel(app.viewer->selection, 2, false);
  EXPECT_EQ(app.viewer->selection.taxels, (std::vector<int>{2})) << "alone";
  app.viewer->selection.invert(run.scene.project.layout);
  EXPECT_EQ(app.viewer->selection.taxels, (std::vector<int>{1}));
}

TEST(TimelineSteps, FillEqualColumns) {
  Timeline timeline;
  timeline.lanes = {100, 0, 200, 50};
  timeline.steps = {40, 49};  // 10 columns of 10 pixels
  EXPECT_EQ(step_at(timeline, 50), 40U);
  EXPECT_EQ(step_at(timeline, 100.1f), 40U);
  EXPECT_EQ(step_at(timeline, 109.9f), 40U);
  EXPECT_EQ(step_at(timeline, 110.1f), 41U);
  EXPECT_EQ(step_at(timeline, 199.9f), 49U);
  EXPECT_EQ(step_at(timeline, 250), 49U);
  for (std::uint64_t step = 40; step <= 49; ++step) {
    const float x = x_of(timeline, static_cast<double>(step));
    EXPECT_FLOAT_EQ(x, 105 + 10 * static_cast<float>(step - 40)) << "the middle of its column";
    EXPECT_EQ(step_at(timeline, x), step);
  }
}

TEST(TimelineEvents, HaveDifferentColours) {
  const Palette& colors = palette(true);
  const auto same = [](const ImVec4& a, const ImVec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  const auto color = [&](StepEvent event) { return event_color({0, 0, 0, static_cast<std::uint8_t>(event)}, colors); };
  EXPECT_TRUE(same(color(StepEvent::jump_at_equal_force), colors.error)) << "a change by the method";
  EXPECT_TRUE(same(color(StepEvent::jump), colors.warning));
  EXPECT_TRUE(same(color(StepEvent::disagreement), colors.warning));
  EXPECT_TRUE(same(color(StepEvent::other_layout), colors.layout_mode));
  EXPECT_TRUE(same(color(StepEvent::contact_begins), colors.run));
  EXPECT_TRUE(same(color(StepEvent::contact_ends), colors.dim));
  EXPECT_FALSE(same(colors.error, colors.warning));
}

}  // namespace
}  // namespace taxel::ui
