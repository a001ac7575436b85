// Computes directions into a body, one for each vertex of its skin.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct PadDirection {
  dvec3 direction{0};       ///< inward unit vector
  double least_cosine = 0;  ///< least cosine to the inward normals of the used faces
};

/// Returns the direction at each vertex: minus the angle-weighted normal, if its angles to the inward normals of all
/// faces around the vertex are below 60 degrees; otherwise the direction whose largest angle is smallest. If a face is
/// then still almost edge-on, as on folded or torn tessellations, the smallest faces are left out as long as they are a
/// small fraction of the area around the vertex.
std::vector<PadDirection> pad_directions(const TriMesh& mesh);

/// Returns the direction at one vertex for some of the faces around it.
PadDirection pad_direction(const TriMesh& mesh, int vertex, std::span<const int> faces);

}  // namespace taxel
