// The relative motion of the bodies at a contact surface.
#pragma once

#include "core/hydro/traction.h"

namespace taxel {

/// The damping and friction of the pair of one contact surface, and the velocity of the sensor relative to the other
/// body at M's origin, frame M.
struct SurfaceMotion {
  PairProperties properties;
  Twist V;
  [[nodiscard]] dvec3 velocity(const dvec3& x) const { return V.linear + glm::cross(V.angular, x); }
};

}  // namespace taxel
