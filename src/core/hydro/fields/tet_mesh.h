// A given tetrahedral mesh, and the pressure field on it.
#pragma once

#include <memory>
#include <vector>

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

struct TetMesh {
  std::vector<dvec3> vertices;   ///< positions [m]
  std::vector<ivec4> tets;       ///< four vertices each, in any orientation
  std::vector<double> pressure;  ///< pressures at the vertices [Pa]; empty if the mesh has none
};
using TetMeshPtr = std::shared_ptr<const TetMesh>;

/// Returns the faces that belong to only one tet, outward, with the vertices that they use. Throws Error naming the tet
/// if an index is out of range, three tets share a face, or a tet has no volume; throws Error if there is no tet.
TriMesh boundary_of(const TetMesh& mesh);

/// Builds the field with the pressures of the mesh. Without them p = E min(depth, H)/H, where the depth is the distance
/// of a vertex to the boundary, and H is `thickness`, or the depth of the deepest vertex if `thickness` is 0 (Drake's
/// field of a mesh). Throws Error as boundary_of(), and if no vertex is inside or the modulus is not positive.
PressureFieldPtr make_tet_field(const TetMesh& mesh, double modulus, double thickness);

}  // namespace taxel
