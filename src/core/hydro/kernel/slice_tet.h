// The cut of a tetrahedron by a plane.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/math.h"

namespace taxel {

/// Two corners of a tet.
using TetEdge = std::array<std::size_t, 2>;
/// Edges of a tet that a plane crosses, in the order in which they go around.
struct SliceRing {
  int count;                     ///< 0, 3 or 4
  std::array<TetEdge, 4> edges;  ///< a triangle has its first edge once more at the end
  std::array<int, 4> face{};     ///< face that contains an edge and the next one
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
    if (count == 3) ring.edges[3] = ring.edges[0];
  }
  return rings;
}
inline constexpr std::array<SliceRing, 16> kSliceRings = make_slice_rings();

/// The ends of the four edges of a ring in 16 bits: from bit 4 e on the first corner of edge e, then the second one,
/// two bits each.
constexpr std::array<std::uint16_t, 16> pack_slice_rings() {
  std::array<std::uint16_t, 16> packed{};
  for (std::size_t i = 0; i < packed.size(); ++i) {
    std::size_t ends = 0;
    for (std::size_t e = 0; e < 4; ++e)
      ends |= (kSliceRings[i].edges[e][0] | kSliceRings[i].edges[e][1] << 2) << (4 * e);
    packed[i] = static_cast<std::uint16_t>(ends);
  }
  return packed;
}
inline constexpr std::array<std::uint16_t, 16> kPackedRings = pack_slice_rings();

/// A triangle or a quadrangle.
struct TetSlice {
  std::array<dvec3, 4> points;
  int count = 0;              ///< 0, 3 or 4
  std::array<int, 4> face{};  ///< face of the tet that contains the edge from point i to the next one
};

/// From the signed distances of the corners, counter-clockwise about the direction of growing distance. A corner at
/// distance 0 counts as positive, so a face in the plane belongs to the tet on its negative side alone. Points on an
/// edge are computed from its lower vertex number: neighbours get the same bits.
void slice_tet(const std::array<dvec3, 4>& corners, const ivec4& vertices, const std::array<double, 4>& distances,
               TetSlice& out);

}  // namespace taxel
