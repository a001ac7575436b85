#include "ui/scene/sensor_view.h"

#include "core/hydro/traction.h"

namespace taxel::ui {
namespace {

Aabb posed_bounds(const TriMesh& mesh, const Pose& X_WG) {
  Aabb box;
  const RigidTransform X(X_WG);
  const Aabb& b = mesh.bounds();
  for (int i = 0; i < 8; ++i) {
    box.include(X({(i & 1) != 0 ? b.hi.x : b.lo.x, (i & 2) != 0 ? b.hi.y : b.lo.y, (i & 4) != 0 ? b.hi.z : b.lo.z}));
  }
  return box;
}

}  // namespace

std::vector<SensorView> sensor_views(const SceneInput& input) {
  std::vector<SensorView> out;
  if (input.frame && input.frame->scene) {
    const auto& models = input.frame->scene->sensors;
    for (std::size_t i = 0; i < models.size() && i < input.frame->sensors.size(); ++i) {
      const SensorStep& state = input.frame->sensors[i];
      const int index = static_cast<int>(i);
      if (models[i]) out.push_back({index, models[i], &state, state.X_WM, -1, {}, {}});
    }
  } else if (input.document_model) {
    const bool pressed = input.probe && input.probe->model == input.document_model && input.probe->problem.empty();
    out.push_back(
        {0, input.document_model, pressed ? &input.probe->state : nullptr, Pose{}, -1, {}, input.hidden_taxels});
  }
  for (SensorView& view : out) {
    if (view.index != input.selected_sensor) continue;
    const int count = view.model->taxel_count();
    if (input.selected_taxel < count) view.selected_taxel = input.selected_taxel;
    view.selected_taxels = input.selected_taxels;
    std::vector<int>& all = view.selected_taxels;
    std::erase_if(all, [count](int taxel) { return taxel >= count; });
    const auto place = std::lower_bound(all.begin(), all.end(), view.selected_taxel);
    if (view.selected_taxel >= 0 && !view.selected(view.selected_taxel)) all.insert(place, view.selected_taxel);
  }
  return out;
}

std::optional<dvec3> center_of_pressure(const SensorStep& state) {
  CenterOfPressure center;
  for (const ContactSurface& surface : state.surfaces) center.add(surface);
  return center.value();
}

Aabb sensor_bounds(const SceneInput& input) {
  Aabb box;
  for (const SensorView& view : sensor_views(input)) box.include(posed_bounds(*view.model->mesh, view.X_WM));
  return box;
}

Aabb scene_bounds(const SceneInput& input) {
  Aabb box = sensor_bounds(input);
  if (!input.frame || !input.frame->scene) return box;
  const SimScene& scene = *input.frame->scene;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    const SceneGeom& geom = scene.geoms[i];
    if (geom.mesh && !geom.plane && geom.sensor < 0 && shows(input.overlays, geom))
      box.include(posed_bounds(*geom.mesh, input.frame->geom_poses[i]));
  }
  return box;
}

SceneGround scene_ground(const SceneInput& input) {
  SceneGround ground;
  if (input.frame && input.frame->scene) {
    const SimScene& scene = *input.frame->scene;
    for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
      if (scene.geoms[i].plane && shows(input.overlays, scene.geoms[i])) return {input.frame->geom_poses[i], true};
    }
  }
  const Aabb box = scene_bounds(input);
  if (!box.empty()) ground.X_WP.p.z = std::min(0.0, box.lo.z);
  return ground;
}

}  // namespace taxel::ui
