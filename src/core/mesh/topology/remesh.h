// Meshes with more or fewer triangles: subdivision splits each triangle into four, decimation collapses the edges first
// that change the surface least.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

enum class SubdivisionScheme {
  midpoint,  ///< new vertices at the middles of edges; the surface does not change
  loop       ///< scheme of Loop 1987, which smooths and shrinks the surface
};

/// The largest number of faces that subdivide() makes.
inline constexpr long kMaxSubdividedFaces = 4'000'000;

/// Splits every face into four, `times` times. Closed shells stay closed. Throws Error if `times` is not
/// positive, if the result would have more than kMaxSubdividedFaces, or if the mesh is not a manifold.
TriMesh subdivide(const TriMesh& mesh, int times, SubdivisionScheme scheme);

/// Collapses edges until `faces` remain, or until every collapse would change the topology or turn a face by more than
/// 60 degrees. Each collapse moves one vertex onto its neighbour, in the order of the quadric error (Garland, Heckbert
/// 1997). Rims do not change, and closed shells stay closed. Deterministic. Throws Error if `faces` is not positive or
/// not below the mesh's number of faces, or if the mesh is not a manifold.
TriMesh decimate(const TriMesh& mesh, int faces);

}  // namespace taxel
