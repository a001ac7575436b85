// A ray against the solid bodies of a picture.
#pragma once

#include <optional>

#include "core/mesh/query/bvh.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct GeomHit {
  int geom = -1;  ///< in scene->geoms
  double t = 0;   ///< along the ray [m]
};

/// First geom that the ray meets, sensors left out. Every triangle of the geoms whose box it meets is tested.
std::optional<GeomHit> cast_geoms(const SceneInput& input, const Ray& ray_W);

/// The same ray as seen from an inner frame.
Ray in_frame(const Pose& X_WF, const Ray& ray_W);

}  // namespace taxel::ui
