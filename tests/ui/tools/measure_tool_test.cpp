// The measure tool: the clicks that add points, and the request made of these points.
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "ui/tools/pointer.h"
#include "ui/tools/tool_scene.h"

#include <gtest/gtest.h>

namespace taxel::ui {
namespace {

const dvec2 kTaxelPixel(400, 300), kBackgroundPixel(5, 5), kLowerPixel(420, 340), kUpperPixel(430, 270);  // [pixels]

/// A measure that was begun over a ball with a taxel in front.
struct MeasureScene {
  test::ToolScene ball{{dvec3(1, 0, 0)}};
  App& app = ball.app;
  MeasureState& measure = app.get<MeasureState>();
  bool has_other_tool = false;

  MeasureScene() { toggle(); }
  void toggle() { toggle_measure(*app.viewer, app.shown->document, measure); }
  bool handle(const PointerEvent& event) {
    return handle_measure_mouse(*app.ui, *app.viewer, *app.shown, has_other_tool, measure, scene_input(app), event);
  }
  bool click(const dvec2& at) { return handle(test::release(at)); }
  [[nodiscard]] std::optional<MeasureRequest> request() const {
    return measure_request(*app.viewer, app.shown->document, measure);
  }
};

TEST(MeasureTool, TogglesInLayoutOnly) {
  MeasureScene scene;
  EXPECT_TRUE(scene.measure.on);
  scene.toggle();
  EXPECT_FALSE(scene.measure.on);
  scene.app.viewer->mode = Mode::simulate;
  scene.toggle();
  EXPECT_FALSE(scene.measure.on);
}

TEST(MeasureTool, AddsAPointForEachClick) {
  MeasureScene scene;
  EXPECT_TRUE(scene.click(kLowerPixel));
  EXPECT_TRUE(scene.click(kUpperPixel));
  ASSERT_EQ(scene.measure.points.size(), 2U);
  EXPECT_NE(scene.measure.points[0].at, scene.measure.points[1].at);
}

TEST(MeasureTool, SnapsToTheCentreOfATaxel) {
  MeasureScene scene;
  EXPECT_TRUE(scene.click(kTaxelPixel + dvec2(3, 0)));
  EXPECT_EQ(scene.measure.points.at(0).taxel, 1);
  EXPECT_EQ(scene.measure.points.at(0).at, scene.app.shown->document.model->layout.taxels[0].center);
}

TEST(MeasureTool, ShowsWhereTheNextPointWouldBe) {
  MeasureScene scene;
  EXPECT_FALSE(scene.handle(test::hover(kLowerPixel)));
  EXPECT_TRUE(scene.measure.hover);
  EXPECT_FALSE(scene.handle(test::hover(kBackgroundPixel)));
  EXPECT_FALSE(scene.measure.hover);
}

TEST(MeasureTool, ConsumesClicksNextToTheSkin) {
  MeasureScene scene;
  EXPECT_TRUE(scene.click(kBackgroundPixel)) << "the selection stays";
  EXPECT_TRUE(scene.measure.points.empty());
}

TEST(MeasureTool, LeavesDragsToTheCamera) {
  MeasureScene scene;
  EXPECT_FALSE(scene.handle(test::drag(kLowerPixel, {5, 0})));
  EXPECT_FALSE(scene.handle(test::release(kLowerPixel, true)));
  EXPECT_TRUE(scene.measure.points.empty());
}

TEST(MeasureTool, LeavesClicksToTheViewWithCtrlOrShift) {
  MeasureScene scene;
  PointerEvent event = test::release(kLowerPixel);
  event.ctrl = true;
  EXPECT_FALSE(scene.handle(event));
  event.ctrl = false, event.shift = true;
  EXPECT_FALSE(scene.handle(event));
  EXPECT_TRUE(scene.measure.points.empty());
}

TEST(MeasureTool, WaitsWhileAnotherToolIsInUse) {
  MeasureScene scene;
  scene.has_other_tool = true;
  EXPECT_FALSE(scene.click(kLowerPixel));
  EXPECT_TRUE(scene.measure.points.empty());
}

TEST(MeasureRequest, NeedsTwoPointsInLayout) {
  MeasureScene scene;
  scene.click(kLowerPixel);
  EXPECT_FALSE(scene.request());
  scene.click(kUpperPixel);
  ASSERT_TRUE(scene.request());
  EXPECT_EQ(scene.request()->a, scene.measure.points[0].at);
  EXPECT_EQ(scene.request()->b, scene.measure.points[1].at);
  scene.app.viewer->mode = Mode::simulate;
  EXPECT_FALSE(scene.request());
}

}  // namespace
}  // namespace taxel::ui
