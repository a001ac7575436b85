// Decimation: collapses the edges first that change the surface least.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Collapses edges until `faces` remain, or until every collapse would change the topology or turn a face by more than
/// 60 degrees. Each collapse moves one vertex onto its neighbour, in the order of the quadric error (Garland, Heckbert
/// 1997). Rims do not change, and closed shells stay closed. Deterministic. Throws Error if `faces` is not positive or
/// not below the mesh's number of faces, or if the mesh is not a manifold.
TriMesh decimate(const TriMesh& mesh, int faces);

}  // namespace taxel
