#include "ui/scene/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/hydro/traction.h"
#include "core/mesh/query/triangle.h"

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

std::string label_of_sensor(const SimScene& scene, std::size_t sensor) {
  for (const std::vector<std::string>* names : {&scene.sensor_labels, &scene.sensor_geoms})
    if (sensor < names->size() && !(*names)[sensor].empty()) return (*names)[sensor];
  return fmt::format("sensor {}", sensor);
}

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

std::vector<glm::vec4> contact_spheres(const SceneInput& input, std::size_t most) {
  std::vector<glm::vec4> spheres;
  for (const SensorView& view : sensor_views(input)) {
    if (view.state == nullptr) continue;
    for (const ContactSurface& surface : view.state->surfaces) {
      Aabb box;
      for (const dvec3& p : surface.vertices) box.include(p);
      if (box.diagonal() > 0) spheres.emplace_back(glm::vec3(view.X_WM * box.center()), 0.5 * box.diagonal());
    }
  }
  std::stable_sort(spheres.begin(), spheres.end(), [](const auto& a, const auto& b) { return a.w > b.w; });
  if (spheres.size() > most) spheres.resize(most);
  return spheres;
}

bool shows_coverage(const SceneInput& input, const SensorModelPtr& model) {
  return field_map(input.overlays) == FieldMap::coverage && input.fields &&
         input.fields->request.map == FieldMap::coverage && input.fields->of(model) != nullptr;
}

bool shows_opaque_skins(const SceneInput& input) {
  const std::vector<SensorView> views = sensor_views(input);
  return !input.overlays.sensor_transparent || std::any_of(views.begin(), views.end(), [&](const SensorView& view) {
    return shows_coverage(input, view.model);
  });
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

namespace {

/// Calls visit(name, pose) for each part of one kind, except the body of the world.
template <class Visit>
void visit_bodies(const SimFrame& frame, const Visit& visit) {
  const std::vector<SceneBody>& bodies = frame.scene->controls.bodies;
  for (std::size_t b = 1; b < bodies.size() && b < frame.mark_poses.bodies.size(); ++b)
    visit(bodies[b].name, frame.mark_poses.bodies[b]);
}

template <class Visit>
void visit_geoms(const SceneInput& input, const Visit& visit) {
  const std::vector<SceneGeom>& geoms = input.frame->scene->geoms;
  for (std::size_t g = 0; g < geoms.size() && g < input.frame->geom_poses.size(); ++g)
    if (shows(input.overlays, geoms[g])) visit(geoms[g].shown_name(), input.frame->geom_poses[g]);
}

template <class Visit>
void visit_sites(const SceneInput& input, const Visit& visit) {
  for (const SceneSite& site : input.frame->scene->marks.sites) {
    const std::optional<Pose> X_WS = site_pose(*input.frame, site);
    if (X_WS && shows(input.overlays, site)) visit(site.name, *X_WS);
  }
}

template <class Visit>
void visit_joints(const SimFrame& frame, const Visit& visit) {
  for (const SceneJointPlace& joint : frame.scene->marks.joints) {
    const auto body = static_cast<std::size_t>(joint.body);
    if (body < frame.mark_poses.bodies.size()) visit(joint.name, frame.mark_poses.bodies[body] * joint.p_B);
  }
}

template <class Visit>
void visit_cameras(const SimFrame& frame, const Visit& visit) {
  const std::vector<SceneCamera>& cameras = frame.scene->marks.cameras;
  for (std::size_t c = 0; c < cameras.size() && c < frame.mark_poses.cameras.size(); ++c)
    visit(cameras[c].name, frame.mark_poses.cameras[c].p);
}

}  // namespace

std::optional<Pose> site_pose(const SimFrame& frame, const SceneSite& site) {
  const auto body = static_cast<std::size_t>(site.body);
  if (body >= frame.mark_poses.bodies.size()) return std::nullopt;
  return frame.mark_poses.bodies[body] * site.X_BS;
}

std::vector<Pose> shown_frames(const SceneInput& input) {
  std::vector<Pose> frames;
  if (!input.frame || !input.frame->scene) return frames;
  const auto add = [&](const std::string& /*name*/, const Pose& X_WF) { frames.push_back(X_WF); };
  switch (input.overlays.frames) {
    case FramesShown::none:
      break;
    case FramesShown::bodies:
      visit_bodies(*input.frame, add);
      break;
    case FramesShown::geoms:
      visit_geoms(input, add);
      break;
    case FramesShown::sites:
      visit_sites(input, add);
      break;
    case FramesShown::world:
      frames.emplace_back();
      break;
  }
  return frames;
}

std::vector<NamedPlace> labelled_places(const SceneInput& input) {
  std::vector<NamedPlace> places;
  if (!input.frame || !input.frame->scene) return places;
  const auto at = [&](const std::string& name, const dvec3& p_W) { places.push_back({&name, p_W}); };
  const auto at_origin = [&](const std::string& name, const Pose& X_WF) { at(name, X_WF.p); };
  switch (input.overlays.labels) {
    case LabelsShown::none:
      break;
    case LabelsShown::bodies:
      visit_bodies(*input.frame, at_origin);
      break;
    case LabelsShown::joints:
      visit_joints(*input.frame, at);
      break;
    case LabelsShown::geoms:
      visit_geoms(input, at_origin);
      break;
    case LabelsShown::sites:
      visit_sites(input, at_origin);
      break;
    case LabelsShown::cameras:
      visit_cameras(*input.frame, at);
      break;
  }
  return places;
}

Ray in_frame(const Pose& X_WF, const Ray& ray_W) {
  const Pose X_FW = X_WF.inverse();
  return {X_FW * ray_W.origin, X_FW.rotate(ray_W.direction), ray_W.t_max};
}

std::optional<GeomHit> cast_geoms(const SceneInput& input, const Ray& ray_W) {
  if (!input.frame || !input.frame->scene) return std::nullopt;
  const SimScene& scene = *input.frame->scene;
  GeomHit best;
  double t_max = ray_W.t_max;
  for (std::size_t i = 0; i < scene.geoms.size() && i < input.frame->geom_poses.size(); ++i) {
    const SceneGeom& geom = scene.geoms[i];
    if (!geom.mesh || geom.sensor >= 0 || !shows(input.overlays, geom)) continue;
    const Ray ray = in_frame(input.frame->geom_poses[i], ray_W);
    if (SlabTest(ray).entry(geom.mesh->bounds(), t_max) == SlabTest::kMiss) continue;
    const RayTriangleTest test(ray);
    for (int f = 0; f < geom.mesh->face_count(); ++f) {
      const auto hit = test(geom.mesh->vertex(f, 0), geom.mesh->vertex(f, 1), geom.mesh->vertex(f, 2), t_max);
      if (!hit) continue;
      t_max = hit->t;
      best = {static_cast<int>(i), hit->t};
    }
  }
  return best.geom >= 0 ? std::optional(best) : std::nullopt;
}

}  // namespace taxel::ui
