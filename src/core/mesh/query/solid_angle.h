// The solid angle of a triangle: summed over a closed mesh it separates inside from outside.
#pragma once

#include <cmath>

#include "core/base/math.h"

namespace taxel {

/// Returns the solid angle of the triangle (a, b, c) seen from the origin [sr], positive if the origin lies behind the
/// triangle, as inside of a closed mesh (van Oosterom, Strackee 1983).
inline double solid_angle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double numerator = glm::dot(a, glm::cross(b, c));
  const double denominator = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(numerator, denominator);
}

}  // namespace taxel
