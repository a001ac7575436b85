// The half-edges of an edge that belong together, also at edges of more than two faces.
#pragma once

#include "core/mesh/repair/topology.h"

namespace taxel {

/// Pairs of half-edges with solid between their faces: twins, and those of an edge of more than two faces by the angles
/// of the faces around the edge. Half-edges that run alike, or that are too many, stay without a partner.
std::vector<HalfEdgePair> pair_half_edges(const Draft& draft, const EdgeTopology& edges);

}  // namespace taxel
