// Geometry of the tets of a field: their volumes, the tets that fill a prism between a triangle and its image farther
// inside or the gap between two prisms, and whether two tets share volume.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
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

/// Returns true if two tets share volume, by separating axes: two convex bodies are disjoint if and only if their
/// projections are disjoint on the normal of a face of one of them, or on the cross product of an edge of each. Tets
/// that only touch, or whose common part is thinner than 1e-9 of their size, count as disjoint.
inline bool tets_overlap(const std::array<dvec3, 4>& a, const std::array<dvec3, 4>& b) {
  constexpr double kTouching = 1e-9, kParallel = 1e-12;
  constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  double size = 0;
  for (std::size_t i = 1; i < 4; ++i) size = std::max({size, glm::distance(a[0], a[i]), glm::distance(b[0], b[i])});
  const auto apart = [&](const dvec3& axis) {
    const double length = glm::length(axis);
    if (!(length > kParallel * size * size)) return false;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double a_low = kInfinity, a_high = -kInfinity, b_low = kInfinity, b_high = -kInfinity;
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = glm::dot(axis, a[i] - a[0]), y = glm::dot(axis, b[i] - a[0]);
      a_low = std::min(a_low, x);
      a_high = std::max(a_high, x);
      b_low = std::min(b_low, y);
      b_high = std::max(b_high, y);
    }
    return std::min(a_high, b_high) - std::max(a_low, b_low) <= kTouching * size * length;
  };
  for (const std::array<dvec3, 4>* tet : {&a, &b}) {
    const auto& x = *tet;
    for (std::size_t i = 0; i < 4; ++i) {
      const dvec3 &o = x[(i + 1) % 4], &p = x[(i + 2) % 4], &q = x[(i + 3) % 4];
      if (apart(glm::cross(p - o, q - o))) return false;
    }
  }
  for (const auto& [i, j] : kEdges) {
    for (const auto& [k, l] : kEdges) {
      if (apart(glm::cross(a[j] - a[i], b[l] - b[k]))) return false;
    }
  }
  return true;
}

}  // namespace taxel
