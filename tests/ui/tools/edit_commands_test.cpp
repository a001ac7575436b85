// Commands about selection, tools and edits: the state they change at once, and the edit they post.
#include <gtest/gtest.h>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/select/select.h"
#include "app/studio/nouns/table/table_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/shell/interface/carry_out.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A ball with taxels 1, 2 and 3, open in LAYOUT.
struct Ball : test::ToolScene {
  test::InterfaceFrames interface;
  Ball() : ToolScene({dvec3(1, 0, 0), dvec3(1, 0.5, 0), dvec3(1, 0, 0.5)}) {}
  template <class C>
  void run(const C& command) {
    carry_out_if_enabled(command, app);
  }
  /// Returns the newest posted edit, which must be of this kind.
  template <class E>
  [[nodiscard]] const E& edit() const {
    return std::get<E>(asked<EditProject>()->edit);
  }
};

TEST(DeleteSelected, DeletesTheSelectedTaxels) {
  Ball ball;
  ball.app.viewer->selection.taxels = {3, 1};
  ball.run(DeleteSelected{});
  EXPECT_EQ(ball.edit<DeleteTaxels>().ids, (std::vector<int>{3, 1}));
}

TEST(DeleteSelected, IsDisabledWithoutSelection) {
  Ball ball;
  ball.run(DeleteSelected{});
  EXPECT_TRUE(ball.app.ui->commands.empty());
}

TEST(DeleteSelected, IsDisabledInSimulate) {
  Ball ball;
  ball.app.viewer->selection.set(1);
  ball.app.viewer->mode = Mode::simulate;
  ball.run(DeleteSelected{});
  EXPECT_TRUE(ball.app.ui->commands.empty());
}

TEST(HideSelected, AddsToHiddenTaxelsAndClearsTheSelection) {
  Ball ball;
  ball.project.hidden = {2};
  ball.publish();
  ball.app.viewer->selection.set(3);
  ball.run(HideSelected{});
  EXPECT_EQ(ball.edit<SetHidden>().ids, (std::vector<int>{2, 3}));
  EXPECT_TRUE(ball.app.viewer->selection.empty());
}

TEST(ShowOnlySelected, HidesTheOthersAndKeepsTheSelection) {
  Ball ball;
  ball.app.viewer->selection.set(2);
  ball.run(ShowOnlySelected{});
  EXPECT_EQ(ball.edit<SetHidden>().ids, (std::vector<int>{1, 3}));
  EXPECT_EQ(ball.app.viewer->selection.taxels, (std::vector<int>{2}));
}

TEST(ShowOnlySelected, ShowsAllIfTheOthersAreHidden) {
  Ball ball;
  ball.project.hidden = {1, 3};
  ball.publish();
  ball.app.viewer->selection.set(2);
  ball.run(ShowOnlySelected{});
  EXPECT_TRUE(ball.edit<SetHidden>().ids.empty());
}

TEST(MoveInOrder, MovesTheSelectedTaxelByOnePlace) {
  Ball ball;
  ball.app.viewer->selection.set(2);
  ball.run(MoveInOrder{true});
  EXPECT_EQ(ball.edit<ReorderTaxels>().ids, (std::vector<int>{2, 1, 3}));
  ball.run(MoveInOrder{false});
  EXPECT_EQ(ball.edit<ReorderTaxels>().ids, (std::vector<int>{1, 3, 2}));
}

TEST(ProjectSelectedBack, PutsTaxelsOntoTheSkin) {
  Ball ball;
  const dvec3 on_skin = ball.project.layout.taxels[0].center;
  ball.project.layout.taxels[0].center = 1.2 * on_skin;
  ball.publish();
  ball.app.viewer->selection.set(1);
  ball.run(ProjectSelectedBack{});
  const TaxelChange& change = ball.edit<SetTaxels>().changes.at(0);
  EXPECT_EQ(change.id, 1);
  EXPECT_LT(glm::distance(*change.center, on_skin), 1e-4);
  EXPECT_GT(change.normal->x, 0.9) << "the normal of the face";
}

TEST(MirrorSelected, MirrorsAcrossThePlaneOfTheSensorFrame) {
  Ball ball;
  ball.app.viewer->selection.set(2);
  ball.run(MirrorSelected{});
  const SensorFrame& frame = ball.project.layout.frame;
  EXPECT_EQ(ball.edit<MirrorTaxels>().ids, (std::vector<int>{2}));
  EXPECT_NEAR(glm::dot(ball.edit<MirrorTaxels>().plane.normal, frame.distal), 0, 1e-12);
  EXPECT_NEAR(glm::dot(ball.edit<MirrorTaxels>().plane.normal, frame.pad), 0, 1e-12);
  EXPECT_EQ(ball.edit<MirrorTaxels>().skin, ball.app.shown->document.model->skin);
}

TEST(SelectAll, SkipsHiddenTaxels) {
  Ball ball;
  ball.project.hidden = {2};
  ball.publish();
  ball.run(SelectAll{});
  EXPECT_EQ(ball.app.viewer->selection.taxels.size(), 2U);
  EXPECT_FALSE(ball.app.viewer->selection.contains(2));
}

TEST(InvertSelection, SelectsTheOtherShownTaxels) {
  Ball ball;
  ball.project.hidden = {3};
  ball.publish();
  ball.app.viewer->selection.set(1);
  ball.run(InvertSelection{});
  EXPECT_EQ(ball.app.viewer->selection.taxels, (std::vector<int>{2}));
}

TEST(SelectNone, ClearsTheSelection) {
  Ball ball;
  EXPECT_FALSE(is_enabled(binding_of(SelectNone{}), ball.app)) << "nothing is selected";
  ball.app.viewer->selection.set(1);
  ball.run(SelectNone{});
  EXPECT_TRUE(ball.app.viewer->selection.empty());
}

TEST(RenameSelected, OpensTheNameOfTheActiveTaxelInTheTable) {
  Ball ball;
  ball.app.get<PanelsShown>()[kTaxelTable] = false;
  ball.app.viewer->selection.taxels = {3, 1};
  ball.run(RenameSelected{});
  EXPECT_TRUE(ball.app.get<PanelsShown>()[kTaxelTable]);
  EXPECT_EQ(ball.app.get<TableState>().cell->id, 1);
  EXPECT_EQ(ball.app.get<TableState>().cell->column, TableColumn::name);
}

TEST(ShowAllTaxels, IsEnabledIfTaxelsAreHidden) {
  Ball ball;
  const EditProject hide{SetHidden{}, {}};
  const Binding* const row = &binding_of(hide);
  EXPECT_STREQ(row->label, "Show all");
  EXPECT_FALSE(is_enabled(*row, ball.app));
  ball.project.hidden = {1};
  ball.publish();
  carry_out_if_enabled(*row, ball.app);
  EXPECT_TRUE(ball.edit<SetHidden>().ids.empty());
}

TEST(ToggleTool, StartsAToolAndLeavesIt) {
  Ball ball;
  ball.run(ToggleTool{Tool::place});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::place);
  ball.run(ToggleTool{Tool::place});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::none);
}

TEST(ToggleTool, ReplacesAnotherTool) {
  Ball ball;
  ball.run(ToggleTool{Tool::brush});
  ball.run(ToggleTool{Tool::lasso});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::lasso);
}

TEST(ToggleTool, IsDisabledForALassoWithoutTaxels) {
  Ball ball;
  ball.project.layout.taxels.clear();
  ball.publish();
  ball.run(ToggleTool{Tool::lasso});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::none);
  ball.run(ToggleTool{Tool::place});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::place) << "a place needs none";
}

TEST(ToggleProbe, CancelsTheToolAndHoldsTheProbe) {
  Ball ball;
  ball.run(ToggleTool{Tool::place});
  ball.run(ToggleProbe{});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::none);
  EXPECT_TRUE(ball.app.get<ProbeState>().on && ball.app.get<ProbeState>().held);
  EXPECT_TRUE(is_checked(binding_of(ToggleProbe{}), ball.app));
  ball.run(ToggleProbe{});
  EXPECT_FALSE(ball.app.get<ProbeState>().on);
}

TEST(ToggleProbe, IsDisabledInSimulate) {
  Ball ball;
  ball.app.viewer->mode = Mode::simulate;
  ball.run(ToggleProbe{});
  EXPECT_FALSE(ball.app.get<ProbeState>().on);
}

TEST(ToggleMeasure, ForgetsThePointsWhenItEnds) {
  Ball ball;
  ball.run(ToggleMeasure{});
  EXPECT_TRUE(ball.app.get<MeasureState>().on);
  ball.app.get<MeasureState>().points.resize(2);
  ball.run(ToggleMeasure{});
  EXPECT_FALSE(ball.app.get<MeasureState>().on);
  EXPECT_TRUE(ball.app.get<MeasureState>().points.empty());
}

TEST(ToggleGenerate, ForgetsThePreviewWhenItCloses) {
  Ball ball;
  GenerateState& generate = ball.app.get<GenerateState>();
  ball.run(ToggleGenerate{});
  EXPECT_TRUE(generate.open);
  generate.ghosts = std::make_shared<const std::vector<Taxel>>(1);
  ball.run(ToggleGenerate{});
  EXPECT_FALSE(generate.open);
  EXPECT_EQ(generate.ghosts, nullptr);
  EXPECT_FALSE(generate.waiting());
}

TEST(BeginGesture, StartsWithTheSelectedTaxels) {
  Ball ball;
  ball.app.viewer->selection.taxels = {1, 3};
  ball.run(BeginGesture{Tool::move});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::move);
  ASSERT_EQ(ball.app.get<ToolState>().start.size(), 2U);
  EXPECT_EQ(ball.app.get<ToolState>().start.back().id, 3) << "the active one is last";
}

TEST(BeginGesture, IsDisabledWithoutSelection) {
  Ball ball;
  ball.run(BeginGesture{Tool::turn});
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::none);
}

TEST(BeginGesture, SelectsCopiesThatHaveNewIds) {
  Ball ball;
  ball.app.viewer->selection.set(2);
  ball.run(BeginGesture{Tool::move, true});
  EXPECT_EQ(ball.app.viewer->selection.taxels, (std::vector<int>{4}));
  EXPECT_TRUE(ball.app.get<ToolState>().adds);
}

TEST(ConstrainGesture, FreesAnAxisThatIsChosenTwice) {
  Ball ball;
  ball.app.viewer->selection.set(1);
  ball.run(BeginGesture{Tool::move});
  ball.run(ConstrainGesture{1});
  EXPECT_EQ(ball.app.get<ToolState>().input.axis, 1);
  ball.run(ConstrainGesture{2});
  EXPECT_EQ(ball.app.get<ToolState>().input.axis, 2);
  ball.run(ConstrainGesture{2});
  EXPECT_EQ(ball.app.get<ToolState>().input.axis, -1);
}

TEST(CancelTool, RestoresTheSelectionAndCancelsTheGesture) {
  Ball ball;
  ball.app.viewer->selection.set(2);
  ball.run(BeginGesture{Tool::move, true});
  const std::uint64_t gesture = ball.app.get<ToolState>().gesture;
  ball.run(CancelTool{});
  EXPECT_EQ(ball.asked<CancelGesture>()->number, gesture);
  EXPECT_EQ(ball.app.viewer->selection.taxels, (std::vector<int>{2}));
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::none);
}

TEST(AcceptGesture, EndsTheGesture) {
  Ball ball;
  ball.app.viewer->selection.set(2);
  ball.run(BeginGesture{Tool::resize});
  ball.run(AcceptGesture{});
  EXPECT_NE(ball.asked<EndGesture>(), nullptr);
  EXPECT_EQ(ball.asked<CancelGesture>(), nullptr);
  EXPECT_EQ(ball.app.get<ToolState>().tool, Tool::none);
}

TEST(UndoStep, IsEnabledIfAnEditCanBeUndone) {
  Ball ball;
  ball.run(UndoStep{});
  EXPECT_EQ(ball.asked<UndoStep>(), nullptr);
  ball.app.shown->document.editing.undo_depth = 1;
  ball.run(UndoStep{});
  EXPECT_NE(ball.asked<UndoStep>(), nullptr);
  ball.run(RedoStep{});
  EXPECT_EQ(ball.asked<RedoStep>(), nullptr);
}

TEST(PasteTaxels, NeedsADocumentButNoSelection) {
  Ball ball;
  ball.run(CopyTaxels{});
  EXPECT_EQ(ball.asked<CopyTaxels>(), nullptr);
  ball.run(PasteTaxels{});
  EXPECT_NE(ball.asked<PasteTaxels>(), nullptr);
}

}  // namespace
}  // namespace taxel::ui
