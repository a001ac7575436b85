// The relative motion of the bodies at a contact surface.
#pragma once

#include "core/hydro/bristles.h"

namespace taxel {

/// The damping and friction of the pair of one contact surface, and the velocity of the sensor relative to the other
/// body at M's origin, frame M.
struct SurfaceMotion {
  PairProperties properties;
  Twist V;
  /// Friction that sticks, or null if it is regularised. Valid during one step; null in recorded motions.
  const StickingFriction* sticking = nullptr;
  [[nodiscard]] dvec3 velocity(const dvec3& x) const { return V.linear + glm::cross(V.angular, x); }
  /// Returns the friction on the sensor at a point x of the surface with normal n and elastic pressure p0 [Pa].
  [[nodiscard]] dvec3 friction(double p0, const dvec3& n, const dvec3& x) const {
    return sticking ? sticking->traction_at(x) : friction_traction(p0, n, velocity(x), properties);
  }
};

}  // namespace taxel
