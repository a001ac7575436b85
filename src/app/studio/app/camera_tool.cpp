#include "app/studio/app/camera_tool.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/actions.h"
#include "app/studio/app/reading_range.h"
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
#include "ui/scene/pick/gizmo.h"

namespace taxel::ui {

namespace {

bool simulated(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::simulate && input.frame && input.frame->scene;
}

void include_mesh(Aabb& box, const TriMesh& mesh, const Pose& X_WM) {
  const RigidTransform transform(X_WM);
  for (const dvec3& p : mesh.vertices()) box.include(transform(p));
}

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
  constexpr double kPerNotch = 0.02;  // of the size of what is shown
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

/// A press and release at the same place, as ImGui tells clicks from drags.
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

/// With Ctrl the camera goes along with what it centres on.
void centre_on(UiState& ui, const UiInput& input, const Pick& under) {
  if (ImGui::GetIO().KeyCtrl && simulated(ui, input)) return track_body(ui, input, under);
  free_camera(ui);
  ui.camera().target = under.position_W;
}

}  // namespace

SceneInput scene_input(const UiState& ui, const UiInput& input) {
  SceneInput scene;
  if (ui.mode == Mode::simulate) scene.frame = input.frame;
  scene.document_model = input.model;
  if (ui.mode == Mode::layout) scene.probe = input.probe;
  scene.clip = ui.clip;
  scene.fields = input.fields;
  if (ui.mode == Mode::layout && ui.measure.on) {
    scene.measured = input.measured;
    for (const MeasurePoint& point : ui.measure.points) scene.measure_points.push_back(point.at);
    if (ui.measure.hover) scene.measure_points.push_back(ui.measure.hover->at);
  }
  if (ui.mode == Mode::simulate && ui.saved.panels.explain) {
    if (input.frame && ui.saved.overlays.ghost) scene.before = input.frame->before;
    if (ui.explain.polygon) {
      scene.marked_surface = ui.explain.polygon->surface;
      scene.marked_polygon = ui.explain.polygon->polygon;
    }
  }
  scene.path = edited_path(ui, input);
  scene.overlays = ui.saved.overlays;
  scene.range = ui.range;
  scene.reading_range = reading_range(ui, input);
  scene.selected_sensor = ui.selection.sensor;
  scene.selected_body = ui.mode == Mode::simulate ? ui.selection.body : -1;
  if (const SensorModelPtr model = input.shown_model(ui)) {
    scene.selected_taxel = active_index(ui.selection, model->layout);
    scene.selected_taxels = selected_indices(ui.selection, model->layout);
  }
  if (ui.mode == Mode::layout && input.editing.project && input.model) {
    for (const int id : input.editing.project->hidden) {
      if (const int index = index_of(input.model->layout, id); index >= 0) scene.hidden_taxels.push_back(index);
    }
    std::sort(scene.hidden_taxels.begin(), scene.hidden_taxels.end());
  }
  if (ui.mode == Mode::layout && input.editing.project) scene.region = input.editing.project->layout.sampling.region;
  if (ui.mode == Mode::layout && ui.generate.open) scene.ghosts = ui.generate.ghosts;
  scene.repair_changes = ui.mode == Mode::layout && ui.mesh.shows_changes;
  scene.dark = ui.dark;
  scene.scale = ui.pixel_scale;
  return scene;
}

void toggle_clip(UiState& ui, const UiInput& input) {
  const Aabb box = scene_box(ui, input);
  if (ui.clip || box.empty()) return ui.clip.reset();
  const Camera& camera = ui.camera();
  const dvec3 towards_eye = glm::normalize(camera.eye() - camera.target);
  ui.clip = ClipPlane{towards_eye, glm::dot(towards_eye, box.center())};
}

Pose shown_pose(const UiState& ui, const UiInput& input) {
  const SensorStep* sensor = ui.mode == Mode::simulate ? input.sensor(ui) : nullptr;
  return sensor != nullptr ? sensor->X_WM : Pose{};
}

Aabb scene_box(const UiState& ui, const UiInput& input) {
  Aabb box;
  if (!simulated(ui, input)) {
    if (input.model) box = input.model->mesh->bounds();
    return box;
  }
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.sensors.size() && i < input.frame->sensors.size(); ++i) {
    include_mesh(box, *scene.sensors[i]->mesh, input.frame->sensors[i].X_WM);
  }
  for (const dvec3& p : scene.path_W) box.include(p);
  if (!scene.path_W.empty()) return box;
  const Aabb sensors = box;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    if (!scene.geoms[i].plane && scene.geoms[i].mesh && shows(ui.saved.overlays, scene.geoms[i]))
      include_mesh(box, *scene.geoms[i].mesh, input.frame->geom_poses[i]);
  }
  constexpr double kMuchLarger = 5;  // a room around a hand
  return !sensors.empty() && box.diagonal() > kMuchLarger * sensors.diagonal() ? sensors : box;
}

Aabb selection_box(const UiState& ui, const UiInput& input) {
  Aabb box;
  const SensorModelPtr model = input.shown_model(ui);
  if (!model) return box;
  for (const int index : selected_indices(ui.selection, model->layout)) {
    const Taxel& taxel = model->layout.taxels[static_cast<std::size_t>(index)];
    const dvec3 center_W = shown_pose(ui, input) * taxel.center;
    box.include(center_W - dvec3(taxel.radius));
    box.include(center_W + dvec3(taxel.radius));
  }
  return box;
}

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
