#include "app/studio/frame/shown_scene.h"

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/reading_range.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

namespace {

bool has_simulated_scene(const Viewer& viewer, const RunView& run) {
  return viewer.mode == Mode::simulate && run.frame && run.frame->scene;
}

void include_mesh(Aabb& box, const TriMesh& mesh, const Pose& X_WM) {
  const RigidTransform transform(X_WM);
  for (const dvec3& p : mesh.vertices()) box.include(transform(p));
}

/// Sets the taxel under the pointer: the one whose centre is there, or the nearest one of the sample that is there.
void set_hovered(const App& app, SceneInput& scene) {
  if (!app.viewer->hovered || scene.overlays.all_taxels) return;
  const Pick& under = *app.viewer->hovered;
  const auto sensor = static_cast<std::size_t>(under.sensor);
  SensorModelPtr model = scene.document_model;
  if (scene.frame && scene.frame->scene)
    model = under.sensor >= 0 && sensor < scene.frame->scene->sensors.size() ? scene.frame->scene->sensors[sensor]
                                                                             : nullptr;
  if (!model || under.sensor < 0) return;
  const auto sample = static_cast<std::size_t>(under.sample);
  if (under.taxel >= 0) {
    scene.hovered_taxel = under.taxel;
  } else if (under.sample >= 0 && sample < model->taxels_of_sample.size() && !model->taxels_of_sample[sample].empty()) {
    scene.hovered_taxel = model->taxels_of_sample[sample].front();
  }
  if (scene.hovered_taxel >= 0) scene.hovered_sensor = under.sensor;
}

}  // namespace

SceneInput scene_input(const App& app) {
  SceneInput scene;
  if (app.viewer->mode == Mode::simulate) scene.frame = app.shown->run.frame;
  scene.document_model = app.shown->document.model;
  if (app.viewer->mode == Mode::layout) scene.probe = app.shown->document.probe;
  scene.clip = app.viewer->clip;
  scene.fields = app.shown->document.fields;
  scene.overlays = app.viewer->overlays();
  scene.range = app.viewer->range;
  scene.reading_range = reading_range(*app.viewer, *app.shown);
  scene.selected_sensor = app.viewer->selection.sensor;
  scene.selected_body = app.viewer->mode == Mode::simulate ? app.viewer->selection.body : -1;
  if (const SensorModelPtr model = app.shown->model(*app.viewer)) {
    scene.selected_taxel = active_index(app.viewer->selection, model->layout);
    scene.selected_taxels = selected_indices(app.viewer->selection, model->layout);
  }
  set_hovered(app, scene);
  if (app.viewer->mode == Mode::layout && app.shown->document.editing.project && app.shown->document.model) {
    for (const int id : app.shown->document.editing.project->hidden) {
      if (const int index = index_of(app.shown->document.model->layout, id); index >= 0)
        scene.hidden_taxels.push_back(index);
    }
    std::sort(scene.hidden_taxels.begin(), scene.hidden_taxels.end());
  }
  if (app.viewer->mode == Mode::layout && app.shown->document.editing.project)
    scene.region = app.shown->document.editing.project->layout.sampling.region;
  scene.dark = app.ui->dark;
  scene.scale = app.ui->pixel_scale;
  for (const Feature* row : features())
    if (row->mark != nullptr) row->mark(app, scene);
  return scene;
}

void toggle_clip(Viewer& viewer, const Shown& shown) {
  const Aabb box = scene_box(viewer, shown);
  if (viewer.clip || box.empty()) return viewer.clip.reset();
  const Camera& camera = viewer.camera();
  const dvec3 towards_eye = glm::normalize(camera.eye() - camera.target);
  viewer.clip = ClipPlane{towards_eye, glm::dot(towards_eye, box.center())};
}

Pose shown_pose(const Viewer& viewer, const Shown& shown) {
  const SensorStep* sensor = viewer.mode == Mode::simulate ? shown.sensor(viewer) : nullptr;
  return sensor != nullptr ? sensor->X_WM : Pose{};
}

Aabb scene_box(const Viewer& viewer, const Shown& shown) {
  Aabb box;
  if (!has_simulated_scene(viewer, shown.run)) {
    if (shown.document.model) box = shown.document.model->mesh->bounds();
    return box;
  }
  const SimScene& scene = *shown.run.frame->scene;
  for (std::size_t i = 0; i < scene.sensors.size() && i < shown.run.frame->sensors.size(); ++i) {
    include_mesh(box, *scene.sensors[i]->mesh, shown.run.frame->sensors[i].X_WM);
  }
  for (const dvec3& p : scene.path_W) box.include(p);
  if (!scene.path_W.empty()) return box;
  const Aabb sensors = box;
  for (std::size_t i = 0; i < scene.geoms.size() && i < shown.run.frame->geom_poses.size(); ++i) {
    if (!scene.geoms[i].plane && scene.geoms[i].mesh && shows(viewer.overlays(), scene.geoms[i]))
      include_mesh(box, *scene.geoms[i].mesh, shown.run.frame->geom_poses[i]);
  }
  constexpr double kMuchLarger = 5;  // a room around a robot hand
  return !sensors.empty() && box.diagonal() > kMuchLarger * sensors.diagonal() ? sensors : box;
}

Aabb selection_box(const Viewer& viewer, const Shown& shown) {
  Aabb box;
  const SensorModelPtr model = shown.model(viewer);
  if (!model) return box;
  if (viewer.selection.empty() && viewer.mode == Mode::simulate && shown.sensor(viewer) != nullptr)
    include_mesh(box, *model->mesh, shown_pose(viewer, shown));
  for (const int index : selected_indices(viewer.selection, model->layout)) {
    const Taxel& taxel = model->layout.taxels[static_cast<std::size_t>(index)];
    const dvec3 center_W = shown_pose(viewer, shown) * taxel.center;
    box.include(center_W - dvec3(taxel.radius));
    box.include(center_W + dvec3(taxel.radius));
  }
  return box;
}

}  // namespace taxel::ui
