// Gestures: their steps, their speed under Ctrl and Shift, and the time of an added waypoint.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

// Steps of the user guide: [m], [degrees], [m].
constexpr double kMoveStep = 1e-3, kTurnStepDeg = 5, kRadiusStep = 0.5e-3;

TEST(GestureSteps, EqualThoseOfTheUserGuide) {
  std::ifstream file(TAXEL_SOURCE_DIR "/docs/user_guide.md");
  std::stringstream guide;
  guide << file.rdbuf();
  EXPECT_NE(guide.str().find("hold Shift for a tenth of the pace and Ctrl to snap (1 mm, 5 degrees, 0.5 mm;"),
            std::string::npos)
      << "kMoveStep, kTurnStepDeg and kRadiusStep of this test are the guide's";
}

TEST(GestureSteps, RoundLengthsToTheNearestStep) {
  GestureInput input;
  EXPECT_EQ(snapped_length(0.00149, input), 0.00149) << "without Ctrl";
  input.precise = true;
  EXPECT_EQ(snapped_length(0.00149, input), 0.00149) << "Shift alone does not snap";
  input.precise = false, input.snap = true;
  EXPECT_NEAR(snapped_length(1.49 * kMoveStep, input), kMoveStep, 1e-15);
  EXPECT_NEAR(snapped_length(1.51 * kMoveStep, input), 2 * kMoveStep, 1e-15);
  EXPECT_NEAR(snapped_length(-1.51 * kMoveStep, input), -2 * kMoveStep, 1e-15);
  input.precise = true;
  EXPECT_NEAR(snapped_length(1.49 * 0.1 * kMoveStep, input), 0.1 * kMoveStep, 1e-15);
  EXPECT_NEAR(snapped_length(1.51 * 0.1 * kMoveStep, input), 0.2 * kMoveStep, 1e-15);
}

/// A gesture on one taxel that faces the eye.
struct OneTaxel {
  test::ToolScene scene{{dvec3(1, 0, 0)}};
  ToolState tool;
  explicit OneTaxel(Tool kind) {
    tool.tool = kind;
    tool.start = scene.project.layout.taxels;
    tool.pointer_start = scene.pixel(tool.start[0].center) + dvec2(100, 0);
    tool.input.pointer = tool.pointer_start;
  }
  [[nodiscard]] TaxelChange change() const {
    const GestureEdit result = gesture_edit(tool, gesture_view(*scene.app.viewer, *scene.app.shown));
    return std::get<SetTaxels>(result.edit.value()).changes.at(0);
  }
};

TEST(GestureSteps, TurnByWholeSteps) {
  OneTaxel one(Tool::turn);
  one.tool.input.axis = 0;
  const auto about_x = [&](double degrees) {
    one.tool.start[0].normal = dvec3(0, 1, 0);
    const dvec2 center = one.scene.pixel(one.tool.start[0].center);
    one.tool.input.pointer = center + 100.0 * dvec2(std::cos(glm::radians(degrees)), -std::sin(glm::radians(degrees)));
    const std::optional<dvec3> normal = one.change().normal;
    return normal ? glm::degrees(std::atan2(normal->z, normal->y)) : 0.0;
  };
  EXPECT_NEAR(about_x(7), 7, 1e-9) << "x points to the eye: as the pointer goes";
  one.tool.input.snap = true;
  EXPECT_NEAR(about_x(7.4), kTurnStepDeg, 1e-9);
  EXPECT_NEAR(about_x(7.6), 2 * kTurnStepDeg, 1e-9);
  EXPECT_NEAR(about_x(-7.6), -2 * kTurnStepDeg, 1e-9);
  one.tool.input.precise = true;
  EXPECT_NEAR(about_x(0.74), 0.1 * kTurnStepDeg, 1e-9);
}

TEST(GestureSteps, TurnWithThePointerSeenFromEitherSide) {
  for (const double elevation : {40.0, -40.0}) {
    OneTaxel one(Tool::turn);
    one.scene.app.viewer->camera().elevation_deg = elevation;  // z points to the eye, or away from the eye
    one.tool.input.axis = 2;
    one.tool.start[0].normal = dvec3(1, 0, 0);
    const dvec2 center = one.scene.pixel(one.tool.start[0].center);
    one.tool.pointer_start = center + dvec2(100, 0);
    one.tool.input.pointer = center + 100.0 * dvec2(std::cos(0.3), -std::sin(0.3));  // to the left
    const dvec3 normal = one.change().normal.value();
    EXPECT_NEAR(std::atan2(normal.y, normal.x), elevation > 0 ? 0.3 : -0.3, 1e-9);
  }
}

TEST(GestureSteps, ResizeToWholeSteps) {
  OneTaxel one(Tool::resize);
  const auto radius = [&](double pulled) {  // pixels outward, of 100
    one.tool.input.pointer = one.tool.pointer_start + dvec2(pulled, 0);
    return one.change().radius.value_or(one.tool.start[0].radius);
  };
  EXPECT_NEAR(radius(10), 0.0022, 1e-12) << "a tenth farther out is a tenth larger";
  EXPECT_NEAR(radius(-10), 0.0018, 1e-12);
  one.tool.input.snap = true;
  EXPECT_NEAR(radius(12), 0.002, 1e-12);
  EXPECT_NEAR(radius(13), 0.002 + kRadiusStep, 1e-12);
  one.tool.input.precise = true;
  EXPECT_NEAR(radius(12), 0.00225, 1e-12);
}

TEST(GestureSteps, MoveAlongAnAxisByTheWayOfThePointer) {
  OneTaxel one(Tool::move);
  one.tool.input.axis = 1;
  const dvec3 center = one.tool.start[0].center;
  for (const double way : {0.0013, -0.0027}) {
    const dvec2 along = one.scene.pixel(center + dvec3(0, way, 0)) - one.scene.pixel(center);
    one.tool.input.snap = false;
    one.tool.input.pointer = one.tool.pointer_start + along;
    EXPECT_NEAR(one.change().center->y - center.y, way, 1e-12);
    one.tool.input.snap = true;
    EXPECT_NEAR(one.change().center->y - center.y, std::round(1e3 * way) * kMoveStep, 1e-12);
    EXPECT_EQ(one.change().center->x, center.x);
    EXPECT_EQ(one.change().center->z, center.z);
  }
}

TEST(GesturePace, IsATenthWithShift) {
  test::InterfaceFrames interface;
  test::ToolScene scene({dvec3(1, 0, 0)});
  scene.app.viewer->selection.set(1);
  const auto move_to = [&](double x, double y) {
    interface.move(x, y);
    interface.frame([&] {
      handle_tool_mouse(*scene.app.ui, *scene.app.viewer, *scene.app.shown, scene.app.get<ToolState>(),
                        scene.app.get<GenerateState>(), scene.app.get<PathState>(), scene_input(scene.app), x, y, true);
    });
  };
  interface.move(400, 300);
  interface.frame([&] {
    begin_gesture(*scene.app.ui, *scene.app.viewer, *scene.app.shown, scene.app.get<ToolState>(),
                  scene.app.get<PathState>(), Tool::move);
  });
  move_to(400, 300);
  const dvec2 begin = scene.app.get<ToolState>().input.pointer;
  move_to(430, 320);
  EXPECT_EQ(scene.app.get<ToolState>().input.pointer, begin + dvec2(30, 20));
  EXPECT_FALSE(scene.app.get<ToolState>().input.precise);
  interface.key(ImGuiMod_Shift, true);
  move_to(440, 300);
  EXPECT_NEAR(scene.app.get<ToolState>().input.pointer.x, begin.x + 31, 1e-9);
  EXPECT_NEAR(scene.app.get<ToolState>().input.pointer.y, begin.y + 18, 1e-9);
  EXPECT_TRUE(scene.app.get<ToolState>().input.precise);
  EXPECT_FALSE(scene.app.get<ToolState>().input.snap);
  interface.key(ImGuiMod_Shift, false);
  interface.key(ImGuiMod_Ctrl, true);
  move_to(450, 300);
  EXPECT_NEAR(scene.app.get<ToolState>().input.pointer.x, begin.x + 41, 1e-9);
  EXPECT_TRUE(scene.app.get<ToolState>().input.snap);
  EXPECT_FALSE(scene.app.get<ToolState>().input.precise);
}

/// A running path of waypoints at these times.
struct RunningPath {
  test::ToolScene scene{{dvec3(1, 0, 0)}};
  Pose X_now{{1, 0, 0, 0}, {0.03, 0.02, 0.01}};
  explicit RunningPath(const std::vector<double>& times) {
    scene.app.viewer->mode = Mode::simulate;
    scene.project.scenario.motion = scenarios::Path{};
    for (const double time : times) scene.project.scenario.as<scenarios::Path>().points.push_back({time, Pose{}});
    scene.publish();
    const auto frame = std::make_shared<SimFrame>();
    frame->scene = std::make_shared<SimScene>();
    frame->sensors.resize(1);
    frame->sensors[0].X_WM = X_now;
    scene.app.shown->run.frame = frame;
    scene.app.shown->run.runs_scenario = true;
  }
  /// Returns the times of the path after a waypoint was added behind the selected one.
  std::vector<double> added(int selected) {
    scene.app.get<PathState>().selected = selected;
    add_way_point(*scene.app.ui, *scene.app.viewer, *scene.app.shown, scene.app.get<PathState>());
    const auto& points = std::get<SetScenario>(scene.asked<EditProject>()->edit).scenario.as<scenarios::Path>().points;
    std::vector<double> times;
    for (const WayPoint& point : points) times.push_back(point.time);
    EXPECT_EQ(points.at(static_cast<std::size_t>(scene.app.get<PathState>().selected)).X_WM.p, X_now.p)
        << "the new one is selected";
    return times;
  }
};

TEST(WayPoints, AreAddedHalfwayOrHalfASecondAfterTheLast) {
  RunningPath path({0, 0.4, 2});
  EXPECT_EQ(path.added(0), (std::vector<double>{0, 0.2, 0.4, 2}));
  EXPECT_EQ(path.added(1), (std::vector<double>{0, 0.4, 1.2, 2}));
  EXPECT_EQ(path.added(2), (std::vector<double>{0, 0.4, 2, 2.5}));
  EXPECT_EQ(path.added(-1), (std::vector<double>{0, 0.4, 2, 2.5})) << "none is selected: at the end";
  EXPECT_EQ(path.added(9), (std::vector<double>{0, 0.4, 2, 2.5})) << "the selected one is gone";
  EXPECT_EQ(RunningPath({}).added(-1), (std::vector<double>{0})) << "the first one";
}

TEST(WayPoints, AreDeletedDownToTwo) {
  RunningPath path({0, 0.4, 2});
  path.scene.app.get<PathState>().selected = 1;
  delete_way_point(*path.scene.app.ui, *path.scene.app.viewer, *path.scene.app.shown, path.scene.app.get<PathState>());
  const auto& points =
      std::get<SetScenario>(path.scene.asked<EditProject>()->edit).scenario.as<scenarios::Path>().points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1].time, 2);
  RunningPath two({0, 1});
  two.scene.app.get<PathState>().selected = 1;
  delete_way_point(*two.scene.app.ui, *two.scene.app.viewer, *two.scene.app.shown, two.scene.app.get<PathState>());
  EXPECT_EQ(two.scene.asked<EditProject>(), nullptr);
}

}  // namespace
}  // namespace taxel::ui
