// Three points that replace a small polygon in an integral: exact for polynomials of degree 2.
#pragma once

#include <array>

#include "core/base/math.h"

namespace taxel {

/// Returns the offsets of three points of equal weight from the centroid of an area with the second moments uu, uv, vv
/// about it, divided by the area [m^2]: sqrt(2) L (cos t, sin t) with t a third of a turn apart and L L^T the matrix of
/// the moments. For a triangle they are on its inscribed ellipse.
inline std::array<dvec2, 3> three_points(double uu, double uv, double vv) {
  // sqrt(2) (cos t, sin t)
  constexpr double kRoot = 1.4142135623730951, kHalf = 0.70710678118654757, kSide = 1.2247448713915889;
  const double l0 = std::sqrt(std::max(0.0, uu)), l1 = l0 > 0 ? uv / l0 : 0,
               l2 = std::sqrt(std::max(0.0, vv - l1 * l1));
  return {dvec2{l0 * kRoot, l1 * kRoot}, dvec2{-l0 * kHalf, -l1 * kHalf + l2 * kSide},
          dvec2{-l0 * kHalf, -l1 * kHalf - l2 * kSide}};
}

}  // namespace taxel
