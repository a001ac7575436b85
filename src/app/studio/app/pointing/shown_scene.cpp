#include "app/studio/app/pointing/shown_scene.h"

#include <algorithm>

#include "app/studio/app/reading_range.h"
#include "app/studio/features/scenario/path_tool.h"

namespace taxel::ui {

namespace {

bool has_simulated_scene(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::simulate && input.frame && input.frame->scene;
}

void include_mesh(Aabb& box, const TriMesh& mesh, const Pose& X_WM) {
  const RigidTransform transform(X_WM);
  for (const dvec3& p : mesh.vertices()) box.include(transform(p));
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
  if (!has_simulated_scene(ui, input)) {
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
  constexpr double kMuchLarger = 5;  // a room around a robot hand
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

}  // namespace taxel::ui
