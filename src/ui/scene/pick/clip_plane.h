// A plane that cuts the sensor open in the 3-D view.
#pragma once

#include <optional>

#include "core/mesh/query/bvh.h"

namespace taxel::ui {

/// A clip plane in the world. Points with dot(normal, p) > offset are hidden.
struct ClipPlane {
  dvec3 normal{0, 0, 1};  ///< unit normal
  double offset = 0;      ///< [m]
  bool operator==(const ClipPlane&) const = default;

  [[nodiscard]] double height(const dvec3& p_W) const { return glm::dot(normal, p_W) - offset; }
  [[nodiscard]] bool hides(const dvec3& p_W) const { return height(p_W) > 0; }
  [[nodiscard]] ClipPlane flipped() const { return {-normal, -offset}; }
};

/// The part of a ray that is not clipped, and the distance that its origin moved; empty if the whole ray is clipped.
struct ShownRay {
  Ray ray;
  double moved = 0;
};
inline std::optional<ShownRay> shown_part(const std::optional<ClipPlane>& clip, Ray ray_W) {
  if (!clip) return ShownRay{ray_W, 0};
  const double height = clip->height(ray_W.origin), rise = glm::dot(clip->normal, ray_W.direction);
  if (height <= 0) {
    if (rise > 0) ray_W.t_max = std::min(ray_W.t_max, -height / rise);
    return ShownRay{ray_W, 0};
  }
  if (rise >= 0 || -height / rise > ray_W.t_max) return std::nullopt;
  const double moved = -height / rise;
  ray_W.origin += moved * ray_W.direction;
  ray_W.t_max -= moved;
  return ShownRay{ray_W, moved};
}

}  // namespace taxel::ui
