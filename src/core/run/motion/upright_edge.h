// The object of the paper's sweep: a box that is balanced on one of its edges.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Height of the sharp edge, where the planes of the two upper sides meet, above the rounded one [m].
double height_of_round(double radius);

/// A box of edge length `size` that is balanced on one edge. The opposite edge points up, is rounded by `radius`, and
/// lies along y. The top of the round is the line x = 0; the lower edge is the line x = 0, z = 0; y goes from -size/2
/// to size/2. A closed mesh; its triangles on the round deviate by at most 3e-4 radius from it. Requires 0 < radius <
/// size/2.
TriMesh make_upright_edge(double size, double radius);

}  // namespace taxel
