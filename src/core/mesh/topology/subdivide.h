// Subdivision: splits each triangle into four.
#pragma once

#include <string_view>

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

}  // namespace taxel
