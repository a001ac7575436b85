#include "core/hydro/kernel/slice_tet.h"

#include <utility>

namespace taxel {
namespace {

using TetEdge = std::array<std::size_t, 2>;
struct SliceRing {
  int count;
  std::array<TetEdge, 4> edges;
  std::array<int, 4> face{};  ///< face that contains an edge and the next one
};

/// The face that holds two edges of the tet: it lies opposite to the corner that neither has.
constexpr int common_face(const TetEdge& a, const TetEdge& b) {
  const unsigned corners = 1u << a[0] | 1u << a[1] | 1u << b[0] | 1u << b[1];
  for (int i = 0; i < 4; ++i) {
    if ((corners & (1u << i)) == 0) return i;
  }
  return -1;  // two opposite edges are never neighbours in a ring
}

/// Edges in the order in which they go around, for each set of corners on the positive side (bit i: corner i), of a
/// positively oriented tet.
constexpr std::array<SliceRing, 16> make_slice_rings() {
  std::array<SliceRing, 16> rings{{
      {0, {}},
      {3, {{{0, 1}, {0, 3}, {0, 2}}}},
      {3, {{{1, 0}, {1, 2}, {1, 3}}}},
      {4, {{{0, 2}, {1, 2}, {1, 3}, {0, 3}}}},
      {3, {{{2, 0}, {2, 3}, {2, 1}}}},
      {4, {{{2, 1}, {0, 1}, {0, 3}, {2, 3}}}},
      {4, {{{1, 0}, {2, 0}, {2, 3}, {1, 3}}}},
      {3, {{{3, 0}, {3, 2}, {3, 1}}}},
      {3, {{{3, 0}, {3, 1}, {3, 2}}}},
      {4, {{{1, 3}, {2, 3}, {2, 0}, {1, 0}}}},
      {4, {{{2, 3}, {0, 3}, {0, 1}, {2, 1}}}},
      {3, {{{2, 0}, {2, 1}, {2, 3}}}},
      {4, {{{0, 3}, {1, 3}, {1, 2}, {0, 2}}}},
      {3, {{{1, 0}, {1, 3}, {1, 2}}}},
      {3, {{{0, 1}, {0, 2}, {0, 3}}}},
      {0, {}},
  }};
  for (SliceRing& ring : rings) {
    const auto count = static_cast<std::size_t>(ring.count);
    for (std::size_t e = 0; e < count; ++e) ring.face[e] = common_face(ring.edges[e], ring.edges[(e + 1) % count]);
  }
  return rings;
}
constexpr std::array<SliceRing, 16> kSliceRings = make_slice_rings();

}  // namespace

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
