// Exact integrals over polygons: over the part inside of a disc, and by three points that replace a small polygon.
#pragma once

#include <array>
#include <span>

#include "core/base/math.h"

namespace taxel {

/// The area of a part of a plane, and its first moments about the centre of the disc.
struct DiscMoments {
  double area = 0;  ///< negative for a clockwise polygon [m^2]
  dvec2 first{0};   ///< integral of the offset from the centre [m^3]
};

/// Returns the integrals over the intersection of a simple polygon with the disc |q - center| <= radius. By Green's
/// theorem they are sums over the edges: an edge inside of the disc adds its triangle with the centre, one outside adds
/// the sector of its ends.
DiscMoments disc_moments(std::span<const dvec2> polygon, const dvec2& center, double radius);

/// Returns three points of equal weight that replace an area in an integral, exact for polynomials of degree 2: their
/// offsets from the centroid. uu, uv, vv are the second moments about it, divided by the area [m^2]. The offsets are
/// sqrt(2) L (cos t, sin t) with t a third of a turn apart and L L^T the matrix of the moments. For a triangle they are
/// on its inscribed ellipse.
inline std::array<dvec2, 3> three_points(double uu, double uv, double vv) {
  // sqrt(2) (cos t, sin t)
  constexpr double kRoot = 1.4142135623730951, kHalf = 0.70710678118654757, kSide = 1.2247448713915889;
  const double l0 = std::sqrt(std::max(0.0, uu)), l1 = l0 > 0 ? uv / l0 : 0,
               l2 = std::sqrt(std::max(0.0, vv - l1 * l1));
  return {dvec2{l0 * kRoot, l1 * kRoot}, dvec2{-l0 * kHalf, -l1 * kHalf + l2 * kSide},
          dvec2{-l0 * kHalf, -l1 * kHalf - l2 * kSide}};
}

}  // namespace taxel
