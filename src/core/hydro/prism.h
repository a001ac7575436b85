// Tets between a triangle and its image further inside.
#pragma once

#include <array>

#include "core/base/math.h"

namespace taxel {

struct PrismTets {
  std::array<ivec4, 3> tets;
  int count = 0;
};

/// Cuts the prism between a triangle, counter-clockwise seen from outside, and the inner vertex of each corner, into
/// three tets of positive volume. The diagonal of a side goes from the skin vertex whose inner vertex has the lower
/// number to the inner vertex of the higher number, so that neighbours cut the side between them alike; so do all sides
/// that end on one inner edge, which may lie in one plane. Where inner vertices coincide with each other or with the
/// corner, the tets that this flattens are left out.
PrismTets split_prism(const ivec3& corners, const ivec3& inner);

}  // namespace taxel
