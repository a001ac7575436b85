#include "core/hydro/prism.h"

namespace taxel {
namespace {

bool has_repeated_vertex(const ivec4& t) {
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

}  // namespace

PrismTets split_prism(const ivec3& corners, const ivec3& inner) {
  int first = 0;  // the lowest number first; turning keeps the orientation
  if (corners[1] < corners[first]) first = 1;
  if (corners[2] < corners[first]) first = 2;
  const int second = (first + 1) % 3, third = (first + 2) % 3;
  const int a = corners[first], b = corners[second], c = corners[third];
  const int ia = inner[first], ib = inner[second], ic = inner[third];
  const std::array<ivec4, 3> all =
      b < c ? std::array<ivec4, 3>{ivec4(a, c, b, ic), ivec4(a, b, ib, ic), ivec4(a, ia, ic, ib)}
            : std::array<ivec4, 3>{ivec4(a, c, b, ib), ivec4(a, ic, c, ib), ivec4(a, ia, ic, ib)};
  PrismTets prism;
  for (const ivec4& t : all) {
    if (!has_repeated_vertex(t)) prism.tets[static_cast<std::size_t>(prism.count++)] = t;
  }
  return prism;
}

}  // namespace taxel
