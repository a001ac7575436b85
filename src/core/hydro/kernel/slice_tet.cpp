// The slice of a tet by a plane, from the signed distances of its corners: the edges with ends on both sides are
// crossed, and the sixteen patterns of signs give their order around the slice (kSliceRings). A corner at distance 0
// counts as positive, so a face in the plane belongs to one of its two tets. Each point is computed from the edge's end
// with the lower vertex number, so both tets at a face get the same bits for a common edge and leave no gap.
#include "core/hydro/kernel/slice_tet.h"

namespace taxel {

void slice_tet(const std::array<dvec3, 4>& corners, const ivec4& vertices, const std::array<double, 4>& distances,
               TetSlice& out) {
  unsigned positive = 0;
  for (unsigned i = 0; i < 4; ++i) positive |= (distances[i] < 0 ? 0u : 1u) << i;
  const SliceRing& ring = kSliceRings[positive];
  out.count = ring.count;
  out.face = ring.face;
  for (std::size_t e = 0; e < static_cast<std::size_t>(ring.count); ++e) {
    const TetEdge& edge = ring.edges[e];
    const std::size_t later = vertices[static_cast<int>(edge[0])] > vertices[static_cast<int>(edge[1])] ? 1 : 0;
    const std::size_t a = edge[later], b = edge[1 - later];
    out.points[e] = corners[a] + distances[a] / (distances[a] - distances[b]) * (corners[b] - corners[a]);
  }
}

}  // namespace taxel
