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

void drag_camera(UiState& ui) {
  if (looks_through_camera(ui)) return;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) ui.camera().orbit(io.MouseDelta.x, io.MouseDelta.y);
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Right)) {
    ui.camera().pan(io.MouseDelta.x, io.MouseDelta.y, ui.view.height, io.KeyShift);
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Middle)) ui.camera().zoom(-0.05 * static_cast<double>(io.MouseDelta.y));
}

void count_clicks(UiState& ui) {
  ui.clicks.left += ImGui::IsMouseClicked(ImGuiMouseButton_Left) ? 1 : 0;
  ui.clicks.right += ImGui::IsMouseClicked(ImGuiMouseButton_Right) ? 1 : 0;
  ui.clicks.left_double += ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ? 1 : 0;
  ui.clicks.right_double += ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right) ? 1 : 0;
}

/// The first notch turns the plane on, facing the eye through the middle; then it goes in and out.
void move_clip(UiState& ui, const UiInput& input, double notches) {
  constexpr double kPerNotch = 0.02;  // fraction of the size of the scene
  const Aabb box = scene_box(ui, input);
  if (box.empty()) return;
  if (!ui.clip) return toggle_clip(ui, input);
  ui.clip->offset -= kPerNotch * box.diagonal() * notches;
}

void turn_wheel(UiState& ui, const UiInput& input, double notches) {
  if (ui.tool.tool == Tool::brush && can_edit(ui, input)) {
    resize_brush(ui, *input.model, notches);
  } else if (ImGui::GetIO().KeyCtrl && ui.generate.open) {
    turn_pattern(ui, notches);
  } else if (ImGui::GetIO().KeyCtrl && can_edit(ui, input)) {
    resize_by_wheel(ui, input, notches);
  } else if (ImGui::GetIO().KeyShift) {
    move_clip(ui, input, notches);
  } else if (!looks_through_camera(ui)) {
    ui.camera().zoom(notches);
  }
}

/// Whether a button was pressed and released at the same place, by ImGui's threshold of a drag.
bool clicked_in_place(ImGuiMouseButton button) {
  const ImGuiIO& io = ImGui::GetIO();
  return ImGui::IsMouseReleased(button) &&
         io.MouseDragMaxDistanceSqr[button] < io.MouseDragThreshold * io.MouseDragThreshold;
}

void select_under(UiState& ui, const UiInput& input, const std::optional<Pick>& under) {
  if (under && under->sensor >= 0 && ui.mode == Mode::simulate) ui.selection.sensor = under->sensor;
  if (under && under->polygon >= 0 && under->taxel < 0 && ui.mode == Mode::simulate)
    return inspect_polygon(ui, input, {under->surface, under->polygon});
  const bool shift = ImGui::GetIO().KeyShift;
  const SensorModelPtr model = input.shown_model(ui);
  if (under && under->taxel >= 0 && model && under->taxel < model->taxel_count()) {
    click_taxel(ui, model->layout.taxels[static_cast<std::size_t>(under->taxel)].id, shift);
  } else if (!shift) {
    ui.selection.clear();
  }
}

/// Centres the camera on a pick; with Ctrl the camera follows it.
void centre_on(UiState& ui, const UiInput& input, const Pick& under) {
  if (ImGui::GetIO().KeyCtrl && ui.mode == Mode::simulate && input.frame && input.frame->scene)
    return track_body(ui, input, under);
  free_camera(ui);
  ui.camera().target = under.position_W;
}

}  // namespace

void handle_view_mouse(UiState& ui, const UiInput& input) {
  const ImGuiIO& io = ImGui::GetIO();
  const double x = static_cast<double>(io.MousePos.x - ui.view.rect.x0);
  const double y = static_cast<double>(io.MousePos.y - ui.view.rect.y0);
  const bool hovered = ImGui::IsItemHovered();
  ui.hovered.reset();
  if (hovered) count_clicks(ui);
  if (handle_probe_mouse(ui, input, x, y, hovered) || handle_measure_mouse(ui, input, x, y, hovered)) return;
  if (hovered && io.MouseWheel != 0) turn_wheel(ui, input, static_cast<double>(io.MouseWheel));
  if (handle_tool_mouse(ui, input, x, y, hovered)) return;
  if (handle_path_mouse(ui, input, x, y, hovered)) return;
  const bool centre = hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right);
  if (!centre && handle_perturb_mouse(ui, input, x, y, hovered)) return;
  if (ImGui::IsItemActive()) drag_camera(ui);
  if (!hovered) return;
  const int axis =
      gizmo_hit(ui.camera(), dvec2(x, y) / ui.pixel_scale, dvec2(ui.view.width, ui.view.height) / ui.pixel_scale);
  const bool left = clicked_in_place(ImGuiMouseButton_Left);
  if (axis >= 0) {
    if (left) free_camera(ui), look_from_axis(ui.camera(), axis);
    return;
  }
  if (left && pick_frame(ui, input, x, y)) return;
  if (left && (io.KeyCtrl || ui.tool.tool == Tool::place) && can_edit(ui, input)) {
    return place_taxel(ui, input, x, y);
  }
  const bool body = ui.mode == Mode::simulate && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  const bool resting = !ImGui::IsAnyMouseDown() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip);
  if (!left && !centre && !resting && !body) return;
  const double reach = kReach * ui.pixel_scale;
  const std::optional<Pick> under =
      pick(scene_input(ui, input), ui.camera(), x, y, ui.view.width, ui.view.height, reach);
  if (left) select_under(ui, input, under);
  if (body) select_body(ui, input, under);
  if (centre && under) centre_on(ui, input, *under);
  if (resting) ui.hovered = under;
}

}  // namespace taxel::ui
