// Taxels around an axis: rings at one height, and helices between two heights.
#pragma once

#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// A number of taxels around an axis. Heights are in metres along `axis` from `origin`. The first taxel is in the half
/// plane of `first`; the others follow counter-clockwise about the axis.
struct AroundAxis {
  int count = 1;
  dvec3 origin{0};
  dvec3 axis{0, 0, 1};    ///< any length
  dvec3 first{1, 0, 0};   ///< any length, not parallel to the axis
  double radius = 0.005;  ///< radius of the receptive fields [m]
};

/// Returns `count` taxels at equal angles on the outermost skin at `height`, with ids 0 ... count - 1. Their distances
/// are equal if the section is round about the axis. Throws Error that names the parameter, or the taxel whose ray
/// toward the axis misses the skin.
std::vector<Taxel> ring(const AroundAxis& around, double height, const MeshIndex& skin);

/// Returns `count` taxels (at least 2) from `bottom` to `top` in equal steps of height and angle. `turns` is the number
/// of turns, not 0; negative turns are clockwise. Throws the errors of ring().
std::vector<Taxel> helix(const AroundAxis& around, double bottom, double top, double turns, const MeshIndex& skin);

}  // namespace taxel
