#include "core/hydro/prism.h"

namespace taxel {
namespace {

bool has_repeated_vertex(const ivec4& t) {
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

}  // namespace

PrismTets split_prism(const ivec3& corners, const ivec3& inner) {
  const auto before = [&](int i, int j) {
    return inner[i] != inner[j] ? inner[i] < inner[j] : corners[i] < corners[j];
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

}  // namespace taxel
