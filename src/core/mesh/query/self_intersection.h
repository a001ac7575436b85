// Where the faces of a mesh cut through each other.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SelfIntersections {
  int pairs = 0;                 ///< of faces without a common vertex, one of which an edge of the other goes through
  int face_a = -1, face_b = -1;  ///< the first such pair, face_a < face_b
  dvec3 place{0};                ///< a point that both share [m]
};

/// Touching, coplanar overlaps and cuts shallower than rounding do not count. O(n log n) where boxes hardly overlap.
SelfIntersections find_self_intersections(const TriMesh& mesh);

}  // namespace taxel
