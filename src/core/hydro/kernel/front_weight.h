// Back faces of a contact surface: polygons that oppose the pressure, such as the far face of a thin plate.
//
//      skin  ------------------------------      the pressure grows downward
//                 ___________ far face           its pressure would push the plate inward: left out
//        plate   |___________|
//                             near face          its pressure pushes the skin: counts
//
// A body that is thinner than its depth is wholly inside of the field. If both of its faces counted, it would feel the
// difference of two pressures, E t/H, instead of E d/H. A polygon counts by a factor w of the angle between its normal,
// which leads into the soft body, and the gradient of that body's pressure. w is 1 up to kFrontCosine, 0 from
// kBackCosine on, and smooth in between, so that a body that turns feels no jump. Pressure, gradient and everything
// that is computed from them contain w; polygons with w = 0 are left out.
#pragma once

#include "core/base/math.h"

namespace taxel {

/// Names one of the two bodies of a contact surface.
enum class BodyOfPair { a, b };

/// Cosines of the angles at which w begins to fall and is 0: 102.7 and 122.7 degrees, about the 5 pi/8 = 112.5 degrees
/// beyond which Drake leaves polygons out. Angles that are nearer to each other make larger steps where a body turns,
/// and a first angle nearer to 90 degrees touches walls along the gradient (docs/decisions/contact.md).
inline constexpr double kFrontCosine = -0.22, kBackCosine = -0.54;

/// Returns true if the factor of a polygon is less than 1. `along` is the product of the gradient and the unit normal,
/// and is negative.
inline bool is_back_face(double along, const dvec3& gradient) {
  return along * along > kFrontCosine * kFrontCosine * glm::dot(gradient, gradient);
}

/// Returns the factor w of a polygon with the unit normal n, which leads into the soft body, and the gradient of the
/// body's pressure: 1 without gradient.
inline double front_weight(const dvec3& n, const dvec3& gradient) {
  const double along = glm::dot(n, gradient);
  if (along >= 0 || !is_back_face(along, gradient)) return 1;
  const double cosine = along / glm::length(gradient);
  const double t = std::max(0.0, (cosine - kBackCosine) / (kFrontCosine - kBackCosine));
  return t * t * (3 - 2 * t);
}

}  // namespace taxel
