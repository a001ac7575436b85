#include "ui/tools/camera_tool.h"

#include <imgui.h>

#include <cmath>

#include "ui/tools/actions.h"

namespace taxel::ui {

namespace {

bool simulated(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::simulate && input.frame && input.frame->scene;
}

void include_mesh(Aabb& box, const TriMesh& mesh, const Pose& X_WM) {
  const RigidTransform transform(X_WM);
  for (const dvec3& p : mesh.vertices()) box.include(transform(p));
}

/// Nearest hit of a world ray on a mesh at X_WM.
void cast_on(const MeshIndex& index, const Pose& X_WM, Ray& ray, std::optional<dvec3>& best) {
  const Pose X_MW = X_WM.inverse();
  const Ray ray_M{X_MW * ray.origin, X_MW.rotate(ray.direction), ray.t_max};
  if (const auto hit = index.cast(ray_M)) {
    ray.t_max = hit->t;
    best = ray.origin + hit->t * ray.direction;
  }
}

/// How far a click may be from a taxel's centre [pixels].
constexpr double kReach = 14;

void drag_camera(UiState& ui) {
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

/// A press and release at the same place, as ImGui tells clicks from drags.
bool clicked_in_place(ImGuiMouseButton button) {
  const ImGuiIO& io = ImGui::GetIO();
  return ImGui::IsMouseReleased(button) &&
         io.MouseDragMaxDistanceSqr[button] < io.MouseDragThreshold * io.MouseDragThreshold;
}

}  // namespace

Pose shown_pose(const UiState& ui, const UiInput& input) {
  const SensorFrameState* sensor = ui.mode == Mode::simulate ? input.sensor(ui) : nullptr;
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
  if (!box.empty()) return box;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    if (!scene.geoms[i].plane && scene.geoms[i].mesh)
      include_mesh(box, *scene.geoms[i].mesh, input.frame->geom_poses[i]);
  }
  return box;
}

Aabb selection_box(const UiState& ui, const UiInput& input) {
  Aabb box;
  const SensorModelPtr model = input.shown_model(ui);
  if (!model || ui.selection.taxel < 0 || ui.selection.taxel >= model->taxel_count()) return box;
  const Taxel& taxel = model->layout.taxels[static_cast<std::size_t>(ui.selection.taxel)];
  const dvec3 center_W = shown_pose(ui, input) * taxel.center;
  box.include(center_W - dvec3(taxel.radius));
  box.include(center_W + dvec3(taxel.radius));
  return box;
}

int taxel_at(const UiState& ui, const UiInput& input, double x, double y) {
  const SensorModelPtr model = input.shown_model(ui);
  if (!model) return -1;
  const Pose X_WM = shown_pose(ui, input);
  const Camera& camera = ui.camera();
  int best = -1;
  double best_distance = kReach * ui.saved.scale;
  for (int i = 0; i < model->taxel_count(); ++i) {
    const Taxel& taxel = model->layout.taxels[static_cast<std::size_t>(i)];
    const dvec3 p_W = X_WM * taxel.center;
    const bool facing = glm::dot(X_WM.rotate(taxel.normal), camera.eye() - p_W) > 0;
    const dvec3 pixel = camera.project(p_W, ui.view.width, ui.view.height);
    const double distance = std::hypot(pixel.x - x, pixel.y - y) + (facing ? 0.0 : 0.5 * best_distance);
    if (pixel.z > 0 && distance < best_distance) {
      best = i;
      best_distance = distance;
    }
  }
  return best;
}

std::optional<dvec3> point_at(const UiState& ui, const UiInput& input, double x, double y) {
  std::optional<dvec3> best;
  Ray ray = ui.camera().pixel_ray(x, y, ui.view.width, ui.view.height);
  if (!simulated(ui, input)) {
    if (input.model) cast_on(*input.model->skin, Pose{}, ray, best);
    return best;
  }
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.sensors.size() && i < input.frame->sensors.size(); ++i) {
    cast_on(*scene.sensors[i]->skin, input.frame->sensors[i].X_WM, ray, best);
  }
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    const SceneGeom& geom = scene.geoms[i];
    if (geom.sensor < 0 && geom.mesh) cast_on(MeshIndex(geom.mesh), input.frame->geom_poses[i], ray, best);
  }
  return best;
}

void handle_view_mouse(UiState& ui, const UiInput& input) {
  const ImGuiIO& io = ImGui::GetIO();
  const double x = io.MousePos.x - ui.view.rect.x0, y = io.MousePos.y - ui.view.rect.y0;
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActive()) drag_camera(ui);
  ui.hovered_taxel = hovered && !ImGui::IsAnyMouseDown() ? taxel_at(ui, input, x, y) : -1;
  if (!hovered) return;
  count_clicks(ui);
  if (io.MouseWheel != 0) ui.camera().zoom(io.MouseWheel);
  if (clicked_in_place(ImGuiMouseButton_Left)) select_taxel(ui, taxel_at(ui, input, x, y));
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right)) {
    if (const auto point = point_at(ui, input, x, y)) ui.camera().target = *point;
  }
}

}  // namespace taxel::ui
