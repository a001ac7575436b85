// The rows of the tools, and the camera and the selection as the pointer moves and sets them.
#include "app/studio/app/pointing/tools.h"

#include <algorithm>
#include <array>

#include "app/studio/app/app.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/brush/brush.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/camera/frame_tool.h"
#include "app/studio/features/explain/explain_tool.h"
#include "app/studio/features/generate/generate.h"
#include "app/studio/features/measure/measure_tool.h"
#include "app/studio/features/perturb/perturb_tool.h"
#include "app/studio/features/probe/probe_tool.h"
#include "app/studio/features/scenario/path_tool.h"
#include "app/studio/features/taxel/gesture.h"
#include "app/studio/features/taxel/tool_mouse.h"
#include "ui/scene/pick/gizmo.h"

namespace taxel::ui {

namespace {

/// Greatest distance between the pointer and the centre of a taxel that it picks, at scale 1 [pixels].
constexpr double kReach = 12;

void drag_camera(App& app, const PointerEvent& event) {
  if (looks_through_camera(*app.viewer, app.simulate->follow)) return;
  Camera& camera = app.viewer->camera();
  if (event.left().dragged()) camera.orbit(event.delta.x, event.delta.y);
  if (event.right().dragged()) camera.pan(event.delta.x, event.delta.y, app.viewer->view.height, event.shift);
  if (event.middle().dragged()) camera.zoom(-0.05 * event.delta.y);
}

void count_clicks(Clicks& clicks, const PointerEvent& event) {
  clicks.left += event.left().pressed ? 1 : 0;
  clicks.right += event.right().pressed ? 1 : 0;
  clicks.left_double += event.left().double_pressed ? 1 : 0;
  clicks.right_double += event.right().double_pressed ? 1 : 0;
}

/// Adds the plane, facing the eye through the middle, at the first notch; later notches move the plane.
void move_clip(Viewer& viewer, const Shown& shown, double notches) {
  constexpr double kPerNotch = 0.02;  // fraction of the size of the scene
  const Aabb box = scene_box(viewer, shown);
  if (box.empty()) return;
  if (!viewer.clip) return toggle_clip(viewer, shown);
  viewer.clip->offset -= kPerNotch * box.diagonal() * notches;
}

bool turn_wheel(App& app, const PointerEvent& event) {
  if (!event.hovered || event.wheel == 0) return false;
  const bool edited = can_edit(*app.viewer, *app.shown);
  if (app.layout->tool.tool == Tool::brush && edited) {
    resize_brush(app.layout->tool, *app.shown->document.model, event.wheel);
  } else if (event.ctrl && app.layout->generate.open) {
    turn_pattern(app.layout->generate, event.wheel);
  } else if (event.ctrl && edited) {
    resize_by_wheel(*app.ui, app.viewer->selection, app.shown->document, app.layout->tool, event.wheel);
  } else if (event.shift) {
    move_clip(*app.viewer, *app.shown, event.wheel);
  } else if (!looks_through_camera(*app.viewer, app.simulate->follow)) {
    app.viewer->camera().zoom(event.wheel);
  }
  return false;  // the tools see where the pointer is
}

bool point_probe(App& app, const PointerEvent& event) {
  return handle_probe_mouse(*app.ui, *app.viewer, *app.shown, app.layout->tool.tool != Tool::none, app.layout->probe,
                            event);
}

bool point_measure(App& app, const PointerEvent& event) {
  if (!app.layout->measure.on) return false;
  const bool has_other_tool = app.layout->tool.tool != Tool::none || app.layout->probe.held;
  return handle_measure_mouse(*app.ui, *app.viewer, *app.shown, has_other_tool, app.layout->measure, scene_input(app),
                              event);
}

bool point_tool(App& app, const PointerEvent& event) {
  // Only a press looks for a taxel in the scene.
  return handle_tool_mouse(*app.ui, *app.viewer, *app.shown, app.layout->tool, app.layout->generate, app.simulate->path,
                           event.left().pressed ? scene_input(app) : SceneInput{}, event.at.x, event.at.y,
                           event.hovered);
}

bool point_path(App& app, const PointerEvent& event) {
  return handle_path_mouse(*app.ui, *app.viewer, *app.shown, app.layout->tool, app.simulate->path, event);
}

/// A double click with the right button centres the camera instead.
bool point_body(App& app, const PointerEvent& event) {
  const bool centres = event.hovered && event.right().double_pressed;
  return !centres && handle_perturb_mouse(*app.ui, *app.viewer, app.shown->run, app.simulate->perturb, event);
}

bool point_camera(App& app, const PointerEvent& event) {
  if (event.grabbed) drag_camera(app, event);
  return !event.hovered;
}

/// Looks along an axis whose end in the gizmo is clicked.
bool point_gizmo(App& app, const PointerEvent& event) {
  const dvec2 size(app.viewer->view.width, app.viewer->view.height);
  const int axis = gizmo_hit(app.viewer->camera(), event.at / app.ui->pixel_scale, size / app.ui->pixel_scale);
  if (axis < 0) return false;
  if (event.left().clicked())
    free_camera(*app.viewer, app.simulate->follow), look_from_axis(app.viewer->camera(), axis);
  return true;
}

bool point_mesh_frame(App& app, const PointerEvent& event) {
  return event.left().clicked() &&
         pick_frame(*app.ui, *app.viewer, *app.shown, app.layout->tool, app.layout->mesh, event.at.x, event.at.y);
}

bool point_place(App& app, const PointerEvent& event) {
  const bool places = event.ctrl || app.layout->tool.tool == Tool::place;
  if (!event.left().clicked() || !places || !can_edit(*app.viewer, *app.shown)) return false;
  place_taxel(*app.ui, *app.viewer, *app.shown, app.layout->tool, event.at.x, event.at.y);
  return true;
}

void select_under(App& app, const std::optional<Pick>& under, bool shift) {
  const bool simulates = app.viewer->mode == Mode::simulate;
  if (under && under->sensor >= 0 && simulates) app.viewer->selection.sensor = under->sensor;
  if (under && under->polygon >= 0 && under->taxel < 0 && simulates)
    return inspect_polygon(app.shown->run, app.simulate->explain, app.window->panels.explain,
                           {under->surface, under->polygon});
  const SensorModelPtr model = app.shown->model(*app.viewer);
  if (under && under->taxel >= 0 && model && under->taxel < model->taxel_count()) {
    click_taxel(app.viewer->selection, model->layout.taxels[static_cast<std::size_t>(under->taxel)].id, shift);
  } else if (!shift) {
    app.viewer->selection.clear();
  }
}

/// Centres the camera on a pick; with Ctrl the camera follows the picked body.
void centre_on(App& app, const Pick& under, bool ctrl) {
  if (ctrl && app.viewer->mode == Mode::simulate && app.shown->run.frame && app.shown->run.frame->scene)
    return track_body(*app.viewer, app.shown->run, app.simulate->follow, under);
  free_camera(*app.viewer, app.simulate->follow);
  app.viewer->camera().target = under.position_W;
}

bool point_selection(App& app, const PointerEvent& event) {
  const bool left = event.left().clicked(), centre = event.right().double_pressed;
  const bool body = app.viewer->mode == Mode::simulate && event.left().double_pressed;
  const bool resting = is_pointer_resting();
  if (!left && !centre && !resting && !body) return false;
  const std::optional<Pick> under = pick(scene_input(app), app.viewer->camera(), event.at.x, event.at.y,
                                         app.viewer->view.width, app.viewer->view.height, kReach * app.ui->pixel_scale);
  if (left) select_under(app, under, event.shift);
  if (body)
    select_body(*app.ui, app.viewer->selection, app.shown->run, app.simulate->perturb, app.simulate->controls, under);
  if (centre && under) centre_on(app, *under, event.ctrl);
  if (resting) app.viewer->hovered = under;
  return true;
}

bool has_any_selection(const App& app) {
  return app.simulate->path.selected >= 0 || !app.viewer->selection.empty() || app.viewer->selection.body >= 0;
}

void clear_selection(App& app) {
  app.simulate->path.selected = -1;
  app.viewer->selection.clear();
  deselect_body(*app.ui, app.viewer->selection, app.simulate->perturb);
}

constexpr std::array kToolRows = {
    ToolSpec{"probe", kLayout, point_probe, 8, [](const App& app) { return app.layout->probe.on; },
             [](App& app) { leave_probe(app.layout->probe); }},
    ToolSpec{"measure", kLayout, point_measure, 7, [](const App& app) { return app.layout->measure.on; },
             [](App& app) { leave_measure(app.layout->measure); }},
    ToolSpec{"wheel", kEverywhere, turn_wheel},
    ToolSpec{"taxel", kEverywhere, point_tool, 2, [](const App& app) { return app.layout->tool.tool != Tool::none; },
             [](App& app) { cancel_tool(*app.ui, app.viewer->selection, app.layout->tool); }},
    ToolSpec{"path", kEverywhere, point_path, 9, [](const App& app) { return app.simulate->path.held; },
             [](App& app) { cancel_way_point_drag(*app.ui, app.simulate->path); }},
    ToolSpec{"perturb", kEverywhere, point_body},
    ToolSpec{"camera", kEverywhere, point_camera, 11, [](const App&) { return true; },
             [](App& app) { free_camera(*app.viewer, app.simulate->follow); }},
    ToolSpec{"gizmo", kEverywhere, point_gizmo},
    ToolSpec{"mesh_frame", kEverywhere, point_mesh_frame, 6,
             [](const App& app) { return app.layout->mesh.pick != FramePick::none; },
             [](App& app) { app.layout->mesh.pick = FramePick::none; }},
    ToolSpec{"place", kLayout, point_place},
    ToolSpec{"selection", kEverywhere, point_selection, 10, has_any_selection, clear_selection},
    ToolSpec{"video", kEverywhere, nullptr, 1, [](const App& app) { return app.simulate->video.progress.active; },
             [](App& app) { app.ui->post(CancelVideo{}); }},
    ToolSpec{"tour", kEverywhere, nullptr, 3, [](const App& app) { return app.window->tour.step >= 0; },
             [](App& app) { app.window->tour.step = -1; }},
    ToolSpec{"generate", kEverywhere, nullptr, 4, [](const App& app) { return app.layout->generate.open; },
             [](App& app) { close_generate(*app.ui, app.layout->generate); }},
    ToolSpec{"help", kEverywhere, nullptr, 5, [](const App& app) { return app.window->panels.help; },
             [](App& app) { app.window->panels.help = false; }},
};

bool is_valid(Context context, Mode mode) {
  return context == kEverywhere || (context == kLayout) == (mode == Mode::layout);
}

}  // namespace

std::span<const ToolSpec> tools() {
  return kToolRows;
}

void cancel_innermost(App& app) {
  const ToolSpec* first = nullptr;
  for (const ToolSpec& tool : kToolRows) {
    if (tool.cancel == nullptr || !tool.active(app)) continue;
    if (first == nullptr || tool.cancel_order < first->cancel_order) first = &tool;
  }
  if (first != nullptr) first->cancel(app);
}

void handle_view_mouse(App& app) {
  const PointerEvent event = read_pointer(app.viewer->view);
  app.viewer->hovered.reset();
  if (event.hovered) count_clicks(app.window->view.clicks, event);
  for (const ToolSpec& tool : kToolRows)
    if (tool.pointer != nullptr && is_valid(tool.context, app.viewer->mode) && tool.pointer(app, event)) return;
}

}  // namespace taxel::ui
