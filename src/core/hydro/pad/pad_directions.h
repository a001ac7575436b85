// Directions into a body, one per vertex of its skin.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct PadDirection {
  dvec3 direction{0};       ///< unit, inward
  double least_cosine = 0;  ///< to the inward normals of the faces around, but for those left out
};

/// Minus the angle-weighted normal, where it makes angles below 60 degrees with the normals of all faces around; else
/// the direction that makes the largest of these angles smallest. Where that leaves a face almost edge on, as on
/// folded or torn tessellations, the smallest faces are left out while they make up little of the area around.
std::vector<PadDirection> pad_directions(const TriMesh& mesh);

/// The same for one vertex and some of the faces around it.
PadDirection pad_direction(const TriMesh& mesh, int vertex, std::span<const int> faces);

}  // namespace taxel
