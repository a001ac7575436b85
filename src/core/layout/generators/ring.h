// Taxels around an axis: rings at one height, and helices from one height to another.
#pragma once

#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Heights are metres along `axis` from `origin`. The first taxel lies in the half plane of `first`.
struct AroundAxis {
  int count = 1;
  dvec3 origin{0};
  dvec3 axis{0, 0, 1};    ///< any length
  dvec3 first{1, 0, 0};   ///< any length, not parallel to the axis; the others follow counter-clockwise about the axis
  double radius = 0.005;  ///< of the receptive fields [m]
};

/// `count` taxels at equal angles where the outermost skin is met from outside at `height`, ids 0 ... count - 1; at
/// equal distances where the section is round about the axis. Throws Error naming the parameter, or the taxel whose ray
/// toward the axis misses the skin.
std::vector<Taxel> ring(const AroundAxis& around, double height, const MeshIndex& skin);

/// `count` taxels from `bottom` to `top` in equal steps of height and angle, `turns` (not 0, negative: clockwise) in
/// all. At least two. Errors as of ring.
std::vector<Taxel> helix(const AroundAxis& around, double bottom, double top, double turns, const MeshIndex& skin);

}  // namespace taxel
