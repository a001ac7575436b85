// Tests whether two tetrahedra share volume.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/math.h"

namespace taxel {

/// Returns true if two tets share volume, by separating axes: two convex bodies are disjoint if and only if their
/// projections are disjoint on the normal of a face of one of them, or on the cross product of an edge of each. Tets
/// that only touch, or whose common part is thinner than 1e-9 of their size, count as disjoint.
inline bool tets_overlap(const std::array<dvec3, 4>& a, const std::array<dvec3, 4>& b) {
  constexpr double kTouching = 1e-9, kParallel = 1e-12;
  constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  double size = 0;
  for (std::size_t i = 1; i < 4; ++i) size = std::max({size, glm::distance(a[0], a[i]), glm::distance(b[0], b[i])});
  const auto apart = [&](const dvec3& axis) {
    const double length = glm::length(axis);
    if (!(length > kParallel * size * size)) return false;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double a_low = kInfinity, a_high = -kInfinity, b_low = kInfinity, b_high = -kInfinity;
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = glm::dot(axis, a[i] - a[0]), y = glm::dot(axis, b[i] - a[0]);
      a_low = std::min(a_low, x);
      a_high = std::max(a_high, x);
      b_low = std::min(b_low, y);
      b_high = std::max(b_high, y);
    }
    return std::min(a_high, b_high) - std::max(a_low, b_low) <= kTouching * size * length;
  };
  for (const std::array<dvec3, 4>* tet : {&a, &b}) {
    const auto& x = *tet;
    for (std::size_t i = 0; i < 4; ++i) {
      const dvec3 &o = x[(i + 1) % 4], &p = x[(i + 2) % 4], &q = x[(i + 3) % 4];
      if (apart(glm::cross(p - o, q - o))) return false;
    }
  }
  for (const auto& [i, j] : kEdges) {
    for (const auto& [k, l] : kEdges) {
      if (apart(glm::cross(a[j] - a[i], b[l] - b[k]))) return false;
    }
  }
  return true;
}

}  // namespace taxel
