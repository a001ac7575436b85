// Tets that fill prisms and the gaps between prisms, so that neighbours share their faces.
//
// A prism is three tets, and each of its quadrilateral sides has a diagonal. Two prisms at a side must choose the same
// one without knowing each other. So the diagonal begins at the skin vertex whose inner vertex has the lower rank: the
// corner with the lowest rank is an end of two diagonals, and the order of the other two decides the third, which
// leaves no cyclic case. Tets with a repeated vertex have no volume and are left out: this is how a prism ends in an
// edge or a point.
//
// A wedge between two prisms turns about its edge, one step at one end at a time; a step at the end of the lower number
// is one tet, at the other end two.
#include "core/hydro/fields/tet_geometry.h"

#include <algorithm>
#include <utility>

namespace taxel {
namespace {

bool has_repeated_vertex(const ivec4& t) {
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

/// All diagonals of a wedge begin at the end of the lower number: that becomes u.
void see_from_the_lower(int& u, int& v, std::vector<int>& at_u, std::vector<int>& at_v) {
  if (u < v) return;
  std::swap(u, v);
  std::swap(at_u, at_v);
  std::reverse(at_u.begin(), at_u.end());
  std::reverse(at_v.begin(), at_v.end());
}

/// Calls the steps of the side that turns about the edge from the first face to the second: from offset vector i to i +
/// 1 of u, with offset vector j of v, or from j to j + 1 of v, with i of u.
template <typename StepOfU, typename StepOfV>
void turn_about_edge(std::size_t at_u, std::size_t at_v, const StepOfU& step_of_u, const StepOfV& step_of_v) {
  std::size_t i = 0, j = 0;
  while (i + 1 < at_u || j + 1 < at_v) {
    if (j + 1 < at_v && (i + 1 == at_u || (j + 1) * at_u <= (i + 1) * at_v)) {
      step_of_v(i, j++);
    } else {
      step_of_u(i++, j);
    }
  }
}

}  // namespace

double six_volumes(const std::array<dvec3, 4>& tet) {
  return glm::dot(glm::cross(tet[1] - tet[0], tet[2] - tet[0]), tet[3] - tet[0]);
}

bool is_flat(const std::array<dvec3, 4>& tet) {
  constexpr double kFlat = 1e-6;
  double size = 0;
  for (std::size_t i = 1; i < 4; ++i) size = std::max(size, glm::distance(tet[0], tet[i]));
  return !(six_volumes(tet) > kFlat * size * size * size);
}

PrismTets split_prism(const ivec3& corners, const ivec3& inner, const ivec3& ranks) {
  const auto before = [&](int i, int j) {
    return ranks[i] != ranks[j] ? ranks[i] < ranks[j] : corners[i] < corners[j];
  };
  int first = 0;  // the lowest first; turning keeps the orientation
  if (before(1, first)) first = 1;
  if (before(2, first)) first = 2;
  const int second = (first + 1) % 3, third = (first + 2) % 3;
  const int a = corners[first], b = corners[second], c = corners[third];
  const int ia = inner[first], ib = inner[second], ic = inner[third];
  const std::array<ivec4, 3> all =
      before(second, third) ? std::array<ivec4, 3>{ivec4(a, c, b, ic), ivec4(a, b, ib, ic), ivec4(a, ia, ic, ib)}
                            : std::array<ivec4, 3>{ivec4(a, c, b, ib), ivec4(a, ic, c, ib), ivec4(a, ia, ic, ib)};
  PrismTets prism;
  for (const ivec4& t : all) {
    if (!has_repeated_vertex(t)) prism.tets[static_cast<std::size_t>(prism.count++)] = t;
  }
  return prism;
}

void split_wedge(int u, int v, std::vector<int> at_u, std::vector<int> at_v, std::vector<ivec4>& tets) {
  see_from_the_lower(u, v, at_u, at_v);
  const auto add = [&](const ivec4& t) {
    if (!has_repeated_vertex(t)) tets.push_back(t);
  };
  turn_about_edge(
      at_u.size(), at_v.size(),
      [&](std::size_t i, std::size_t j) {
        add({u, at_v[j], at_u[i + 1], at_u[i]});
      },
      [&](std::size_t i, std::size_t j) {
        add({u, v, at_v[j + 1], at_v[j]});
        add({u, at_u[i], at_v[j], at_v[j + 1]});
      });
}

std::vector<ivec3> wedge_floor(int u, int v, std::vector<int> at_u, std::vector<int> at_v) {
  see_from_the_lower(u, v, at_u, at_v);
  std::vector<ivec3> floor;
  turn_about_edge(
      at_u.size(), at_v.size(),
      [&](std::size_t i, std::size_t j) { floor.emplace_back(at_v[j], at_u[i], at_u[i + 1]); },
      [&](std::size_t i, std::size_t j) { floor.emplace_back(at_u[i], at_v[j + 1], at_v[j]); });
  return floor;
}

}  // namespace taxel
