// More triangles: each becomes four.
#pragma once

#include <string_view>

#include "core/mesh/tri_mesh.h"

namespace taxel {

enum class SubdivisionScheme {
  midpoint,  ///< new vertices at the middles of the edges: the surface stays as it is
  loop       ///< Loop 1987: smooths the surface towards a spline, and shrinks it
};

/// The largest number of faces that subdivide() makes.
inline constexpr long kMaxSubdividedFaces = 4'000'000;

/// Splits every face into four, `times` times. Closed shells stay closed. Throws Error: `times` not positive, more than
/// kMaxSubdividedFaces, not a manifold.
TriMesh subdivide(const TriMesh& mesh, int times, SubdivisionScheme scheme);

}  // namespace taxel
