// How a contact surface is rubbed.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

/// Of one contact surface: the pair's damping and friction, and the velocity of the sensor relative to what it touches
/// at M's origin, frame M.
struct SurfaceMotion {
  PairProperties properties;
  Twist V;
  [[nodiscard]] dvec3 velocity(const dvec3& x) const { return V.linear + glm::cross(V.angular, x); }
};

}  // namespace taxel
