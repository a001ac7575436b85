// Keys and actions: which key asks for what, and where scales and speeds end.
#include "app/studio/app/actions.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/studio/app/view_actions.h"
#include "app/studio/features/timeline/timeline_lanes.h"
#include "ui/theme.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// The table of keys is written down twice on purpose: a key that changes by mistake differs from bindings.txt. After a
/// change that is wanted: taxelstudio --list-bindings > tests/ui/tools/bindings.txt
TEST(Keys, AreThoseOfTheListInTheTests) {
  std::ifstream file(TAXEL_SOURCE_DIR "/tests/ui/tools/bindings.txt");
  std::stringstream expected;
  expected << file.rdbuf();
  EXPECT_EQ(bindings_as_text(), expected.str());
}

/// A running simulation whose steps 10 to 20 are recorded, with events in 12 and 17; step 15 is shown.
struct Running {
  test::InterfaceFrames interface;
  test::ToolScene scene{{dvec3(1, 0, 0), dvec3(1, 0.5, 0)}};
  Running() {
    scene.ui.mode = Mode::simulate;
    const auto frame = std::make_shared<SimFrame>();
    const auto lanes = std::make_shared<HistoryLanes>();
    for (std::uint64_t step = 10; step <= 20; ++step)
      lanes->steps.push_back({step, 0, 0, static_cast<std::uint8_t>(step == 12 || step == 17 ? 4 : 0)});
    frame->scene = std::make_shared<SimScene>();
    frame->step = 15;
    frame->history.first = 10, frame->history.last = 20, frame->history.steps = 11;
    frame->history.lanes = lanes;
    scene.input.frame = frame;
    scene.input.speed = 1;
  }
  /// The newest request of a kind after a key was pressed.
  template <class Kind>
  const Kind* pressed(ImGuiKey key, ImGuiKey modifier = ImGuiKey_None) {
    scene.ui.requests.clear();
    if (modifier != ImGuiKey_None) interface.key(modifier, true);
    interface.key(key, true);
    interface.frame([&] { handle_keys(scene.ui, scene.input); });
    interface.key(key, false);
    if (modifier != ImGuiKey_None) interface.key(modifier, false);
    interface.frame([&] { handle_keys(scene.ui, scene.input); });
    return scene.asked<Kind>();
  }
};

TEST(Keys, GoThroughTimeInTheRightDirection) {
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
  run.scene.input.replay = -1;
  ASSERT_NE(run.pressed<ReplayHistory>(ImGuiKey_Space, ImGuiMod_Shift), nullptr);
  EXPECT_EQ(run.scene.asked<ReplayHistory>()->direction, 0) << "once more: it stops";
  EXPECT_NE(run.pressed<StepBack>(ImGuiKey_LeftArrow), nullptr);
  EXPECT_NE(run.pressed<StepOnce>(ImGuiKey_RightArrow), nullptr);
  EXPECT_NE(run.pressed<PlayOrPause>(ImGuiKey_Space), nullptr);
  EXPECT_NE(run.pressed<ResetSimulation>(ImGuiKey_Backspace), nullptr);
}

TEST(Actions, SwitchTheOverlayOfTheirName) {
  using O = Overlays;
  const std::vector<std::pair<Action, bool O::*>> named{{Action::toggle_transparent, &O::sensor_transparent},
                                                        {Action::toggle_wireframe, &O::wireframe},
                                                        {Action::toggle_rays, &O::rays},
                                                        {Action::toggle_all_rays, &O::all_rays},
                                                        {Action::toggle_contact, &O::contact_surface},
                                                        {Action::toggle_contact_edges, &O::contact_edges},
                                                        {Action::toggle_tractions, &O::tractions},
                                                        {Action::toggle_skin, &O::readings_on_skin},
                                                        {Action::toggle_ghost, &O::ghost},
                                                        {Action::toggle_filtered, &O::filtered_polygons},
                                                        {Action::toggle_samples, &O::samples},
                                                        {Action::toggle_normals, &O::sample_normals},
                                                        {Action::toggle_taxels, &O::taxels},
                                                        {Action::toggle_labels, &O::taxel_labels},
                                                        {Action::toggle_fields, &O::receptive_fields},
                                                        {Action::toggle_fields_filled, &O::fields_filled},
                                                        {Action::toggle_fields_compared, &O::fields_compared},
                                                        {Action::toggle_coverage, &O::coverage},
                                                        {Action::toggle_normal_angles, &O::normal_angles},
                                                        {Action::toggle_path, &O::path},
                                                        {Action::toggle_grid, &O::grid},
                                                        {Action::toggle_constraints, &O::constraints}};
  Overlays overlays;
  for (const auto& [action, member] : named)
    EXPECT_EQ(overlay_switch(action, overlays), &(overlays.*member)) << binding_of(action).label;
  for (std::size_t group = 0; group < overlays.geom_groups.size(); ++group) {
    const auto of = [&](Action first) { return static_cast<Action>(static_cast<std::size_t>(first) + group); };
    EXPECT_EQ(overlay_switch(of(Action::toggle_group_0), overlays), &overlays.geom_groups[group]);
    EXPECT_EQ(overlay_switch(of(Action::toggle_site_group_0), overlays), &overlays.site_groups[group]);
  }
}

TEST(Actions, OpenThePanelOfTheirName) {
  using P = PanelsShown;
  const std::vector<std::pair<Action, bool P::*>> named{
      {Action::toggle_outliner, &P::outliner},   {Action::toggle_taxel_table, &P::taxels},
      {Action::toggle_inspector, &P::inspector}, {Action::toggle_bars, &P::bars},
      {Action::toggle_plots, &P::plot},          {Action::toggle_map, &P::map},
      {Action::toggle_study, &P::study},         {Action::toggle_section, &P::section},
      {Action::toggle_messages, &P::messages},   {Action::toggle_mesh_report, &P::mesh_report},
      {Action::toggle_profiler, &P::profiler},   {Action::help, &P::help}};
  Running run;
  for (const auto& [action, member] : named) {
    bool& shown = run.scene.ui.saved.panels.*member;
    const bool before = shown;
    perform(action, run.scene.ui, run.scene.input);
    EXPECT_NE(shown, before) << binding_of(action).label;
  }
}

TEST(Actions, LoopAllRecordedStepsOrNone) {
  Running run;
  perform(Action::loop_range, run.scene.ui, run.scene.input);
  EXPECT_EQ(run.scene.asked<SetLoop>()->range, (StepRange{10, 20}));
  run.scene.input.loop = StepRange{10, 20};
  perform(Action::loop_range, run.scene.ui, run.scene.input);
  EXPECT_EQ(run.scene.asked<SetLoop>()->range, std::nullopt);
}

TEST(Actions, ScaleTheInterfaceWithinItsLimits) {
  Running run;
  SavedState& saved = run.scene.ui.saved;
  perform(Action::scale_up, run.scene.ui, run.scene.input);
  EXPECT_FLOAT_EQ(saved.scale, 1.1f);
  for (int i = 0; i < 40; ++i) perform(Action::scale_up, run.scene.ui, run.scene.input);
  EXPECT_FLOAT_EQ(saved.scale, 2.5f);
  for (int i = 0; i < 80; ++i) perform(Action::scale_down, run.scene.ui, run.scene.input);
  EXPECT_FLOAT_EQ(saved.scale, 0.6f);
  perform(Action::scale_reset, run.scene.ui, run.scene.input);
  EXPECT_EQ(saved.scale, 1);
}

TEST(SelectionOfTaxels, KeepsTheActiveOneLast) {
  Running run;
  UiState& ui = run.scene.ui;
  click_taxel(ui, 2, false);
  click_taxel(ui, 1, true);
  EXPECT_EQ(ui.selection.taxels, (std::vector<int>{2, 1})) << "Shift adds";
  click_taxel(ui, 2, true);
  EXPECT_EQ(ui.selection.taxels, (std::vector<int>{1})) << "Shift takes out";
  ui.selection.set_all(run.scene.project.layout);
  EXPECT_EQ(ui.selection.taxels, (std::vector<int>{2, 1})) << "the active one stays active";
  click_taxel(ui, 2, false);
  EXPECT_EQ(ui.selection.taxels, (std::vector<int>{2})) << "alone";
  ui.selection.invert(run.scene.project.layout);
  EXPECT_EQ(ui.selection.taxels, (std::vector<int>{1}));
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

TEST(TimelineEvents, HaveAColourEach) {
  const Palette& colors = palette(true);
  const auto same = [](const ImVec4& a, const ImVec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  const auto color = [&](StepEvent event) { return event_color({0, 0, 0, static_cast<std::uint8_t>(event)}, colors); };
  EXPECT_TRUE(same(color(StepEvent::jump_at_equal_force), colors.error)) << "what the method did";
  EXPECT_TRUE(same(color(StepEvent::jump), colors.warning));
  EXPECT_TRUE(same(color(StepEvent::disagreement), colors.warning));
  EXPECT_TRUE(same(color(StepEvent::other_layout), colors.layout_mode));
  EXPECT_TRUE(same(color(StepEvent::contact_begins), colors.run));
  EXPECT_TRUE(same(color(StepEvent::contact_ends), colors.dim));
  EXPECT_FALSE(same(colors.error, colors.warning));
}

}  // namespace
}  // namespace taxel::ui
