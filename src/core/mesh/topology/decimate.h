// Fewer triangles: the edges whose collapse moves the surface least go first.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Collapses edges until `faces` are left, or none can go without changing the topology or turning a face by more than
/// 60 degrees; the mesh returned says how many are left. Each collapse moves one vertex onto its neighbour, in the
/// order of the quadric error (Garland, Heckbert 1997). Rims stay as they are, closed shells stay closed.
/// Deterministic. Throws Error: `faces` not positive or not below the mesh's number of faces; not a manifold.
TriMesh decimate(const TriMesh& mesh, int faces);

}  // namespace taxel
