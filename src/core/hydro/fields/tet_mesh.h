// A tetrahedral mesh that somebody else made, and the pressure field on it.
#pragma once

#include <memory>
#include <vector>

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

struct TetMesh {
  std::vector<dvec3> vertices;   ///< [m]
  std::vector<ivec4> tets;       ///< four vertices each, in any orientation
  std::vector<double> pressure;  ///< at the vertices [Pa], where the maker gave one; else empty
};
using TetMeshPtr = std::shared_ptr<const TetMesh>;

/// The faces that belong to one tet only, outward, over the vertices that they use. Throws Error naming the tet: an
/// index out of range, a face of three tets, no volume; or where there is no tet.
TriMesh boundary_of(const TetMesh& mesh);

/// Its own pressures; where it has none p = E min(depth, H)/H, the depth being the distance of a vertex to the boundary
/// and H `thickness`, or where that is 0 the depth of the deepest vertex (Drake's field of a mesh). Throws Error: as
/// boundary_of, no vertex inside, modulus not positive.
PressureFieldPtr make_tet_field(const TetMesh& mesh, double modulus, double thickness);

}  // namespace taxel
