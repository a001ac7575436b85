// Tets between a triangle and its image further inside.
#pragma once

#include <array>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Six times the volume, positive where the last corner lies on the side from which the others go counter-clockwise.
double six_volumes(const std::array<dvec3, 4>& tet);

/// Of no or negative volume, but for rounding.
bool is_flat(const std::array<dvec3, 4>& tet);

/// A tet of a pad is well shaped when its volume is at least this part of the third of a straight prism's.
inline constexpr double kMinVolume = 0.05;

struct PrismTets {
  std::array<ivec4, 3> tets;
  int count = 0;
};

/// Cuts the prism between a triangle, counter-clockwise seen from outside, and the inner vertex of each corner, into
/// three tets of positive volume. The diagonal of a side goes from the skin vertex of the lower rank to the inner
/// vertex of the higher one, so that neighbours cut the side between them alike. Ranks are the corners' own numbers, or
/// where several corners share inner vertices those of the latter, so that all sides that end on one inner edge are cut
/// alike: they may lie in one plane. Equal ranks are ordered by the corners' numbers. Where inner vertices coincide
/// with each other or with the corner, the tets that this flattens are left out.
PrismTets split_prism(const ivec3& corners, const ivec3& inner, const ivec3& ranks);

/// Cuts the gap between two such prisms, of faces that hold the edge u -> v and v -> u but have different inner
/// vertices there, into tets of positive volume, ranked by the corners' numbers. at_u and at_v go from the first face's
/// inner vertex to the second one's. Appends to `tets`.
void split_wedge(int u, int v, std::vector<int> at_u, std::vector<int> at_v, std::vector<ivec4>& tets);

/// The triangles of inner vertices that close such a gap further inside, counter-clockwise seen from outside.
std::vector<ivec3> wedge_floor(int u, int v, std::vector<int> at_u, std::vector<int> at_v);

}  // namespace taxel
