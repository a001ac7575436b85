// Angles between directions.
#pragma once

#include "core/base/math.h"

namespace taxel {

/// Returns the angle between two directions of any length, 0 to pi. It is as exact near 0 as anywhere.
inline double angle_between(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Returns the angle between two directions of any length, 0 to 180 degrees.
inline double angle_deg(const dvec3& a, const dvec3& b) {
  return angle_between(a, b) * 180.0 / kPi;
}

}  // namespace taxel
