#include "core/hydro/prism.h"

#include <algorithm>
#include <utility>

namespace taxel {
namespace {

bool has_repeated_vertex(const ivec4& t) {
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

}  // namespace

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
  if (v < u) {  // seen from the other end
    std::swap(u, v);
    std::swap(at_u, at_v);
    std::reverse(at_u.begin(), at_u.end());
    std::reverse(at_v.begin(), at_v.end());
  }
  const auto add = [&](const ivec4& t) {
    if (!has_repeated_vertex(t)) tets.push_back(t);
  };
  // All diagonals begin at u. The side between the prisms turns about the edge from the first face to the second, a
  // step at one of its ends at a time.
  std::size_t i = 0, j = 0;
  while (i + 1 < at_u.size() || j + 1 < at_v.size()) {
    const bool step_v = j + 1 < at_v.size() && (i + 1 == at_u.size() || (j + 1) * at_u.size() <= (i + 1) * at_v.size());
    if (step_v) {
      add({u, v, at_v[j + 1], at_v[j]});
      add({u, at_u[i], at_v[j], at_v[j + 1]});
      ++j;
    } else {
      add({u, at_v[j], at_u[i + 1], at_u[i]});
      ++i;
    }
  }
}

}  // namespace taxel
