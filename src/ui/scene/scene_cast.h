// Intersection of a ray with the solid bodies of a frame.
#pragma once

#include <optional>

#include "core/mesh/query/bvh.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct GeomHit {
  int geom = -1;  ///< index in scene->geoms
  double t = 0;   ///< distance along the ray [m]
};

/// Returns the first geom, except sensors, that the ray intersects. Tests every triangle of each geom whose box the ray
/// intersects.
std::optional<GeomHit> cast_geoms(const SceneInput& input, const Ray& ray_W);

/// Returns a ray in an inner frame F.
Ray in_frame(const Pose& X_WF, const Ray& ray_W);

}  // namespace taxel::ui
