// Gestures on taxels: typed numbers, copies, the surface, and taxels that a click adds.
#include <gtest/gtest.h>

#include <cmath>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A gesture on the taxel of a ball that faces the eye.
struct TaxelGesture : test::ToolScene {
  ToolState tool;
  explicit TaxelGesture(Tool kind, const std::string& typed = "") : ToolScene({dvec3(1, 0, 0)}) {
    tool.tool = kind;
    tool.start = project.layout.taxels;
    tool.input.typed = typed;
    tool.input.pointer = tool.pointer_start = pixel(tool.start[0].center);
  }
  [[nodiscard]] GestureEdit result() const { return gesture_edit(tool, gesture_view(*app.viewer, *app.shown)); }
  [[nodiscard]] TaxelChange change() const { return std::get<SetTaxels>(result().edit.value()).changes.at(0); }
};

/// A ball on which clicks place taxels.
struct PlaceBall : test::ToolScene {
  ToolState tool;
  explicit PlaceBall(const std::vector<dvec3>& directions) : ToolScene(directions) {}
  [[nodiscard]] std::optional<PlacementGhost> ghost(double x = 400, double y = 300) const {
    return placement_ghost(*app.viewer, *app.shown, tool, x, y);
  }
};

TEST(TypedNumber, ReadsCompleteNumbersOnly) {
  EXPECT_EQ(typed_number("1.5"), 1.5);
  EXPECT_EQ(typed_number("-2"), -2.0);
  EXPECT_EQ(typed_number(".5"), 0.5);
  for (const char* incomplete : {"", "-", ".", "-.", "1.5x", " 1"})
    EXPECT_FALSE(typed_number(incomplete)) << '"' << incomplete << '"';
}

TEST(AlongText, NamesLengthAndAxis) {
  EXPECT_EQ(along_text(0.0015, 1), "1.500 mm along Y");
  EXPECT_EQ(along_text(-0.01, 2), "-10.000 mm along Z");
}

TEST(TypedGesture, SetsTheRadiusInMillimetres) {
  const TaxelGesture gesture(Tool::resize, "4.2");
  EXPECT_EQ(gesture.change().radius.value(), 0.0042) << "the number nearest to 4.2 mm";
  EXPECT_EQ(gesture.result().value, "radius 4.200 mm");
  EXPECT_FALSE(gesture.change().center);
}

TEST(TypedGesture, MovesAlongXWithoutAnAxis) {
  const TaxelGesture gesture(Tool::move, "2");
  const dvec3 moved = gesture.change().center.value() - gesture.tool.start[0].center;
  EXPECT_LT(glm::distance(moved, dvec3(0.002, 0, 0)), 1e-15);
  EXPECT_EQ(gesture.result().value, "2.000 mm along X");
}

TEST(TypedGesture, TurnsByTheRightHandRule) {
  TaxelGesture gesture(Tool::turn, "90");
  gesture.tool.input.axis = 2;
  gesture.tool.start[0].normal = {1, 0, 0};
  EXPECT_LT(glm::distance(gesture.change().normal.value(), dvec3(0, 1, 0)), 1e-15);
  EXPECT_EQ(gesture.result().value, "90.00\u00b0 about Z");
}

TEST(GestureEdit, AddsCopiesWithTheirIds) {
  TaxelGesture gesture(Tool::move, "1");
  gesture.tool.adds = true;
  gesture.tool.start[0].id = 5;
  const std::vector<Taxel> added = std::get<AddTaxels>(gesture.result().edit.value()).taxels;
  ASSERT_EQ(added.size(), 1U);
  EXPECT_EQ(added[0].id, 5);
  EXPECT_NEAR(added[0].center.x - gesture.tool.start[0].center.x, 0.001, 1e-15);
}

TEST(GestureEdit, IsEmptyWithoutTaxelsOrTool) {
  TaxelGesture gesture(Tool::box);
  EXPECT_FALSE(gesture.result().edit) << "a box selects, and changes no taxel";
  gesture.tool.tool = Tool::move;
  gesture.tool.start.clear();
  EXPECT_FALSE(gesture.result().edit);
}

TEST(Slide, ChangesNothingUntilThePointerMoves) {
  const TaxelGesture gesture(Tool::slide);
  EXPECT_FALSE(gesture.change().center);
  EXPECT_FALSE(gesture.change().normal);
  EXPECT_EQ(gesture.result().value, "0.00 mm");
}

TEST(Slide, KeepsTheTaxelOnTheSkin) {
  TaxelGesture gesture(Tool::slide);
  const dvec3 target = test::kBallRadius * glm::normalize(dvec3(1, 0.4, 0));
  gesture.tool.input.pointer = gesture.pixel(target);
  EXPECT_LT(glm::distance(gesture.change().center.value(), target), 1e-4) << "within the facets of the ball";
  EXPECT_GT(glm::dot(gesture.change().normal.value(), glm::normalize(target)), 0.99);
}

TEST(Slide, MakesNoEditOnTheBackground) {
  TaxelGesture gesture(Tool::slide);
  gesture.tool.input.pointer = {5, 5};
  EXPECT_FALSE(gesture.result().edit);
}

TEST(ConstrainGesture, LeavesResizeAndSlideFree) {
  for (const Tool kind : {Tool::resize, Tool::slide, Tool::move}) {
    ToolState tool;
    tool.tool = kind;
    constrain_gesture(tool, 2);
    EXPECT_EQ(tool.input.axis, kind == Tool::move ? 2 : -1);
  }
}

TEST(PlacementGhost, TakesTheRadiusOfItsNeighbours) {
  PlaceBall ball({dvec3(1, 0, 0), dvec3(0, 1, 0)});
  ball.project.layout.taxels[0].radius = 0.0011;
  ball.project.layout.taxels[1].radius = 0.0012;
  ball.publish();
  EXPECT_EQ(ball.ghost()->taxel.radius, 0.0012) << "the last taxel's";
  ball.tool.radius = 0.0013;
  EXPECT_EQ(ball.ghost()->taxel.radius, 0.0013) << "that of the taxel placed before";
  ball.app.viewer->selection.set(1);
  EXPECT_EQ(ball.ghost()->taxel.radius, 0.0011) << "the active taxel's";
}

TEST(PlacementGhost, FitsTheRadiusOfAFirstTaxelToTheMesh) {
  const PlaceBall ball({});
  const double diagonal = ball.app.shown->document.model->mesh->bounds().diagonal();
  EXPECT_NEAR(ball.ghost()->taxel.radius, std::min(Taxel{}.radius, 0.15 * diagonal), 1e-15);
}

TEST(PlacementGhost, CountsTheSamplesOfItsField) {
  PlaceBall ball({});
  ball.tool.radius = 0.002;  // a cap of pi (2 mm)^2 at 0.1 samples per mm^2
  const double expected = glm::pi<double>() * 0.002 * 0.002 * 1e5;
  EXPECT_NEAR(ball.ghost()->samples, expected, 0.5 * expected + 1);
  ball.tool.radius = 1;  // normals within 45 degrees: the fraction (1 - cos 45) / 2 of the sphere
  const auto all = static_cast<double>(ball.app.shown->document.model->samples.size());
  EXPECT_NEAR(ball.ghost()->samples, 0.5 * (1 - std::sqrt(0.5)) * all, 0.25 * 0.1464 * all);
}

TEST(PlacementGhost, IsEmptyOnTheBackgroundAndInSimulate) {
  PlaceBall ball({});
  EXPECT_FALSE(ball.ghost(5, 5));
  ball.app.viewer->mode = Mode::simulate;
  EXPECT_FALSE(ball.ghost());
}

TEST(PlaceTaxel, AddsAndSelectsATaxelWithAnUnusedId) {
  PlaceBall ball({dvec3(0, 1, 0)});
  place_taxel(*ball.app.ui, *ball.app.viewer, *ball.app.shown, ball.tool, 400, 300);
  const Taxel& placed = std::get<AddTaxels>(ball.asked<EditProject>()->edit).taxels.at(0);
  EXPECT_EQ(placed.id, 2);
  EXPECT_LT(glm::distance(placed.center, dvec3(test::kBallRadius, 0, 0)), 1e-6);
  EXPECT_EQ(ball.app.viewer->selection.taxels, (std::vector<int>{2}));
  EXPECT_EQ(ball.tool.radius, placed.radius) << "the next taxel has the same radius";
}

TEST(ResizeByWheel, JoinsNotchesOfOneSecondToAStep) {
  test::InterfaceFrames interface;
  test::ToolScene ball({dvec3(1, 0, 0)});
  ball.app.viewer->selection.set(1);
  ToolState tool;
  const auto gesture_after = [&](int frames) {  // of 20 ms
    for (int i = 0; i < frames; ++i) interface.frame([] {});
    resize_by_wheel(*ball.app.ui, ball.app.viewer->selection, ball.app.shown->document, tool, 1);
    return ball.asked<EditProject>()->gesture.number;
  };
  EXPECT_EQ(gesture_after(0), 1U);
  EXPECT_EQ(gesture_after(40), 1U) << "0.8 s later";
  EXPECT_EQ(gesture_after(60), 2U) << "1.2 s later";
}

}  // namespace
}  // namespace taxel::ui
