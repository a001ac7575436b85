#include "app/studio/app/pointing/view_mouse.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/pointing/shown_scene.h"
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

/// How near the pointer must come to a taxel's centre, at scale 1 [pixels].
constexpr double kReach = 12;

void drag_camera(App& app) {
  if (looks_through_camera(app.viewer, app.simulate.follow)) return;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) app.viewer.camera().orbit(io.MouseDelta.x, io.MouseDelta.y);
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Right)) {
    app.viewer.camera().pan(io.MouseDelta.x, io.MouseDelta.y, app.viewer.view.height, io.KeyShift);
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Middle))
    app.viewer.camera().zoom(-0.05 * static_cast<double>(io.MouseDelta.y));
}

void count_clicks(App& app) {
  app.window.view.clicks.left += ImGui::IsMouseClicked(ImGuiMouseButton_Left) ? 1 : 0;
  app.window.view.clicks.right += ImGui::IsMouseClicked(ImGuiMouseButton_Right) ? 1 : 0;
  app.window.view.clicks.left_double += ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ? 1 : 0;
  app.window.view.clicks.right_double += ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right) ? 1 : 0;
}

/// The first notch turns the plane on, facing the eye through the middle; then it goes in and out.
void move_clip(App& app, double notches) {
  constexpr double kPerNotch = 0.02;  // fraction of the size of the scene
  const Aabb box = scene_box(app.viewer, app.shown);
  if (box.empty()) return;
  if (!app.viewer.clip) return toggle_clip(app.viewer, app.shown);
  app.viewer.clip->offset -= kPerNotch * box.diagonal() * notches;
}

void turn_wheel(App& app, double notches) {
  if (app.layout.tool.tool == Tool::brush && can_edit(app.viewer, app.shown)) {
    resize_brush(app.layout.tool, *app.shown.document.model, notches);
  } else if (ImGui::GetIO().KeyCtrl && app.layout.generate.open) {
    turn_pattern(app.layout.generate, notches);
  } else if (ImGui::GetIO().KeyCtrl && can_edit(app.viewer, app.shown)) {
    resize_by_wheel(app.ui, app.viewer.selection, app.shown.document, app.layout.tool, notches);
  } else if (ImGui::GetIO().KeyShift) {
    move_clip(app, notches);
  } else if (!looks_through_camera(app.viewer, app.simulate.follow)) {
    app.viewer.camera().zoom(notches);
  }
}

/// Whether a button was pressed and released at the same place, by ImGui's threshold of a drag.
bool clicked_in_place(ImGuiMouseButton button) {
  const ImGuiIO& io = ImGui::GetIO();
  return ImGui::IsMouseReleased(button) &&
         io.MouseDragMaxDistanceSqr[button] < io.MouseDragThreshold * io.MouseDragThreshold;
}

void select_under(App& app, const std::optional<Pick>& under) {
  if (under && under->sensor >= 0 && app.viewer.mode == Mode::simulate) app.viewer.selection.sensor = under->sensor;
  if (under && under->polygon >= 0 && under->taxel < 0 && app.viewer.mode == Mode::simulate)
    return inspect_polygon(app.shown.run, app.simulate.explain, app.window.panels, {under->surface, under->polygon});
  const bool shift = ImGui::GetIO().KeyShift;
  const SensorModelPtr model = app.shown.model(app.viewer);
  if (under && under->taxel >= 0 && model && under->taxel < model->taxel_count()) {
    click_taxel(app.viewer.selection, model->layout.taxels[static_cast<std::size_t>(under->taxel)].id, shift);
  } else if (!shift) {
    app.viewer.selection.clear();
  }
}

/// Centres the camera on a pick; with Ctrl the camera follows it.
void centre_on(App& app, const Pick& under) {
  if (ImGui::GetIO().KeyCtrl && app.viewer.mode == Mode::simulate && app.shown.run.frame && app.shown.run.frame->scene)
    return track_body(app.viewer, app.shown.run, app.simulate.follow, under);
  free_camera(app.viewer, app.simulate.follow);
  app.viewer.camera().target = under.position_W;
}

}  // namespace

void handle_view_mouse(App& app) {
  const ImGuiIO& io = ImGui::GetIO();
  const double x = static_cast<double>(io.MousePos.x - app.viewer.view.rect.x0);
  const double y = static_cast<double>(io.MousePos.y - app.viewer.view.rect.y0);
  const bool hovered = ImGui::IsItemHovered();
  app.viewer.hovered.reset();
  if (hovered) count_clicks(app);
  const SceneInput scene = scene_input(app);
  if (handle_probe_mouse(app.ui, app.viewer, app.shown, app.layout.tool, app.layout.probe, x, y, hovered) ||
      handle_measure_mouse(app.ui, app.viewer, app.shown, app.layout.tool, app.layout.probe, app.layout.measure, scene,
                           x, y, hovered))
    return;
  if (hovered && io.MouseWheel != 0) turn_wheel(app, static_cast<double>(io.MouseWheel));
  if (handle_tool_mouse(app.ui, app.viewer, app.shown, app.layout.tool, app.layout.generate, app.simulate.path, scene,
                        x, y, hovered))
    return;
  if (handle_path_mouse(app.ui, app.viewer, app.shown, app.layout.tool, app.simulate.path, x, y, hovered)) return;
  const bool centre = hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right);
  if (!centre && handle_perturb_mouse(app.ui, app.viewer, app.shown.run, app.simulate.perturb, x, y, hovered)) return;
  if (ImGui::IsItemActive()) drag_camera(app);
  if (!hovered) return;
  const int axis = gizmo_hit(app.viewer.camera(), dvec2(x, y) / app.ui.pixel_scale,
                             dvec2(app.viewer.view.width, app.viewer.view.height) / app.ui.pixel_scale);
  const bool left = clicked_in_place(ImGuiMouseButton_Left);
  if (axis >= 0) {
    if (left) free_camera(app.viewer, app.simulate.follow), look_from_axis(app.viewer.camera(), axis);
    return;
  }
  if (left && pick_frame(app.ui, app.viewer, app.shown, app.layout.tool, app.layout.mesh, x, y)) return;
  if (left && (io.KeyCtrl || app.layout.tool.tool == Tool::place) && can_edit(app.viewer, app.shown)) {
    return place_taxel(app.ui, app.viewer, app.shown, app.layout.tool, x, y);
  }
  const bool body = app.viewer.mode == Mode::simulate && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  const bool resting = !ImGui::IsAnyMouseDown() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip);
  if (!left && !centre && !resting && !body) return;
  const double reach = kReach * app.ui.pixel_scale;
  const std::optional<Pick> under =
      pick(scene_input(app), app.viewer.camera(), x, y, app.viewer.view.width, app.viewer.view.height, reach);
  if (left) select_under(app, under);
  if (body)
    select_body(app.ui, app.viewer.selection, app.shown.run, app.simulate.perturb, app.simulate.controls, under);
  if (centre && under) centre_on(app, *under);
  if (resting) app.viewer.hovered = under;
}

}  // namespace taxel::ui
