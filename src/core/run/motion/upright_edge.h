// The object of the paper's sweep: a box balanced on one of its edges.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the height of the sharp edge, the intersection of the two upper sides, above the rounded edge [m].
double height_of_round(double radius);

/// Returns a box of edge length `size`, balanced on one edge, as a closed mesh. The opposite edge is on top, parallel
/// to y, and rounded by `radius`; the lower edge is the line x = 0, z = 0; y is between -size/2 and size/2. The flat
/// strips that replace the round lie partly inside and partly outside of it: their mean distance from its axis is
/// `radius`, and they deviate from it by at most 2e-3 radius. Requires 0 < radius < size/2.
TriMesh make_upright_edge(double size, double radius);

}  // namespace taxel
