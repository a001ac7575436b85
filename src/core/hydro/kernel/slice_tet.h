// The cut of a tetrahedron by a plane.
#pragma once

#include <array>

#include "core/base/math.h"

namespace taxel {

/// A triangle or a quadrangle.
struct TetSlice {
  std::array<dvec3, 4> points;
  int count = 0;              ///< 0, 3 or 4
  std::array<int, 4> face{};  ///< face of the tet that contains the edge from point i to the next one
};

/// From the signed distances of the corners, counter-clockwise about the direction of growing distance. A corner at
/// distance 0 counts as positive, so a face in the plane belongs to the tet on its negative side alone. Points on an
/// edge are computed from its lower vertex number: neighbours get the same bits.
void slice_tet(const std::array<dvec3, 4>& corners, const ivec4& vertices, const std::array<double, 4>& distances,
               TetSlice& out);

}  // namespace taxel
