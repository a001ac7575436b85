// Memory that a caller of the contact kernel keeps between calls.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// No step allocates after warm-up. One per thread; its content means nothing between calls.
struct IntersectWorkspace {
  /// Finds pairs by trees alone, without walking from tet to tet: the same polygons in another order. For tests.
  bool tree_form = false;

  std::vector<std::int32_t> triangles;   ///< of the rigid mesh, or tets of A, that may meet the other body
  std::vector<std::int32_t> tets;        ///< that may meet one triangle
  std::vector<std::int32_t> found;       ///< faces of the boundary that may
  std::vector<dvec3> position;           ///< of the rigid mesh's vertices, frame of the soft body
  std::vector<std::int32_t> tet_of;      ///< of each such vertex: the tet that holds it, -1: none was found
  std::vector<std::uint32_t> placed_in;  ///< of each such vertex: the call that wrote the two above
  std::vector<std::uint32_t> seen_in;    ///< of each tet: the triangle, counted over all calls, that last met it
  std::uint32_t call = 0, triangle = 0;
};

}  // namespace taxel
