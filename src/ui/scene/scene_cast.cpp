#include "ui/scene/scene_cast.h"

#include "core/mesh/query/ray_triangle.h"

namespace taxel::ui {

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
