// Splits the prism between a triangle and its image farther inside into tets.
#pragma once

#include <array>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Returns six times the volume of a tet. It is positive if the last corner is on the side from which the other corners
/// appear counter-clockwise.
double six_volumes(const std::array<dvec3, 4>& tet);

/// Returns true if the volume is zero or negative, up to rounding.
bool is_flat(const std::array<dvec3, 4>& tet);

/// Smallest volume of a well-shaped tet of a pad, as a fraction of a third of the volume of a straight prism.
inline constexpr double kMinVolume = 0.05;

struct PrismTets {
  std::array<ivec4, 3> tets;
  int count = 0;
};

/// Splits the prism between a triangle, counter-clockwise seen from outside, and the inner vertices of its corners into
/// three tets of positive volume. The diagonal of a side leads from the skin vertex of lower rank to the inner vertex
/// of higher rank, so neighbouring prisms split their common side in the same way. Ranks are the indices of the
/// corners. If several corners share inner vertices, ranks are the indices of the inner vertices, so that all sides at
/// one inner edge, which may be in one plane, are split in the same way. Equal ranks are ordered by the indices of the
/// corners. If inner vertices coincide with each other or with a corner, the flat tets are left out.
PrismTets split_prism(const ivec3& corners, const ivec3& inner, const ivec3& ranks);

/// Splits the gap between the prisms of two faces, with half-edges u -> v and v -> u but different inner vertices
/// there, into tets of positive volume, ranked by the indices of the corners. at_u and at_v lead from the inner
/// vertices of the first face to those of the second face. Appends to `tets`.
void split_wedge(int u, int v, std::vector<int> at_u, std::vector<int> at_v, std::vector<ivec4>& tets);

/// Returns the triangles of inner vertices that close such a gap at its inner end, counter-clockwise seen from outside.
std::vector<ivec3> wedge_floor(int u, int v, std::vector<int> at_u, std::vector<int> at_v);

}  // namespace taxel
