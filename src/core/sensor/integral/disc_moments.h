// Exact integrals over the part of a polygon that is inside of a disc.
#pragma once

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

}  // namespace taxel
