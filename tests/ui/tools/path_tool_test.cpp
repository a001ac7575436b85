// Waypoints that the pointer selects and drags.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/tools/pointer.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A running path of two waypoints, 20 mm apart.
struct PathScene {
  test::ToolScene ball{{dvec3(1, 0, 0)}};
  App& app = ball.app;
  PathState& path = app.get<PathState>();
  dvec3 first_W{0, -0.01, 0}, second_W{0, 0.01, 0};

  PathScene() {
    app.viewer->mode = Mode::simulate;
    ball.project.scenario.motion = scenarios::Path{};
    std::vector<WayPoint>& points = ball.project.scenario.as<scenarios::Path>().points;
    points.push_back({0, Pose{{1, 0, 0, 0}, first_W}});
    points.push_back({1, Pose{{1, 0, 0, 0}, second_W}});
    ball.publish();
    const auto frame = std::make_shared<SimFrame>();
    frame->scene = std::make_shared<SimScene>();
    frame->sensors.resize(1);
    app.shown->run.frame = frame;
    app.shown->run.runs_scenario = true;
  }
  /// The pixel at which the view shows a waypoint.
  [[nodiscard]] dvec2 pixel(std::size_t point) const {
    return dvec2(app.viewer->project(edited_path(*app.viewer, *app.shown, path)->points_W.at(point)));
  }
  bool handle(const PointerEvent& event) {
    return handle_path_mouse(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), path, event);
  }
};

TEST(PathTool, SelectsTheWaypointUnderThePointer) {
  PathScene scene;
  EXPECT_TRUE(scene.handle(test::press(scene.pixel(1))));
  EXPECT_EQ(scene.path.selected, 1);
  EXPECT_TRUE(scene.handle(test::release(scene.pixel(1))));
  EXPECT_FALSE(scene.path.held);
  EXPECT_TRUE(scene.app.ui->commands.empty()) << "a click changes nothing";
}

TEST(PathTool, LeavesClicksElsewhereToTheView) {
  PathScene scene;
  EXPECT_FALSE(scene.handle(test::press({5, 5})));
  EXPECT_EQ(scene.path.selected, -1);
}

TEST(PathTool, LeavesClicksToTheViewWithCtrlOrShift) {
  PathScene scene;
  PointerEvent event = test::press(scene.pixel(0));
  event.ctrl = true;
  EXPECT_FALSE(scene.handle(event));
  event.ctrl = false, event.shift = true;
  EXPECT_FALSE(scene.handle(event));
  EXPECT_EQ(scene.path.selected, -1);
}

TEST(PathTool, MovesADraggedWaypointInOneGesture) {
  PathScene scene;
  const dvec2 from = scene.pixel(1);
  scene.handle(test::press(from));
  scene.handle(test::drag(from + dvec2(20, 0), {20, 0}));
  const auto* edit = scene.ball.asked<EditProject>();
  ASSERT_NE(edit, nullptr);
  const auto& points = std::get<SetScenario>(edit->edit).scenario.as<scenarios::Path>().points;
  EXPECT_GT(points[1].X_WM.p.y, scene.second_W.y) << "y is to the right";
  EXPECT_EQ(points[0].X_WM.p, scene.first_W);
  const std::uint64_t gesture = edit->gesture.number;
  scene.handle(test::drag(from + dvec2(30, 0), {10, 0}));
  EXPECT_EQ(scene.ball.asked<EditProject>()->gesture.number, gesture);
  scene.handle(test::release(from + dvec2(30, 0), true));
  EXPECT_NE(scene.ball.asked<EndGesture>(), nullptr);
}

TEST(PathTool, UndoesACancelledDrag) {
  PathScene scene;
  const dvec2 from = scene.pixel(1);
  scene.handle(test::press(from));
  scene.handle(test::drag(from + dvec2(20, 0), {20, 0}));
  cancel_way_point_drag(*scene.app.ui, scene.path);
  ASSERT_NE(scene.ball.asked<CancelGesture>(), nullptr);
  EXPECT_EQ(scene.ball.asked<CancelGesture>()->number, scene.path.gesture);
  EXPECT_FALSE(scene.path.held);
}

TEST(PathTool, CancelsNothingBeforeTheWaypointMoves) {
  PathScene scene;
  scene.handle(test::press(scene.pixel(1)));
  cancel_way_point_drag(*scene.app.ui, scene.path);
  EXPECT_EQ(scene.ball.asked<CancelGesture>(), nullptr);
}

TEST(PathTool, ReleasesTheWaypointWhenThePathIsHidden) {
  PathScene scene;
  scene.handle(test::press(scene.pixel(1)));
  scene.app.viewer->overlays().path = false;
  EXPECT_FALSE(scene.handle(test::drag(scene.pixel(1), {1, 0})));
  EXPECT_FALSE(scene.path.held);
}

TEST(PathTool, EditsOnlyARunningScenario) {
  PathScene scene;
  EXPECT_NE(edited_scenario(*scene.app.viewer, *scene.app.shown), nullptr);
  scene.app.shown->run.runs_scenario = false;
  EXPECT_EQ(edited_scenario(*scene.app.viewer, *scene.app.shown), nullptr);
  EXPECT_FALSE(edited_path(*scene.app.viewer, *scene.app.shown, scene.path));
}

}  // namespace
}  // namespace taxel::ui
