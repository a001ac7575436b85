// Corners with integer coordinates, so that pieces of a triangle share their corners exactly.
#pragma once

#include <cstdint>

namespace taxel {

struct LatticeCorner {
  std::int32_t i = 0, j = 0;
};

inline LatticeCorner middle(const LatticeCorner& a, const LatticeCorner& b) {
  return {(a.i + b.i) / 2, (a.j + b.j) / 2};
}

/// A triangle with two long edges, cut across them:
///
///     tip --- 1 --- 2 --- 3 --- a     Each of the 2^halvings strips has parts of the two long edges as its sides;
///       `---- 1 --- 2 --- 3 --- b     strips are as long as the triangle is wide, or up to half of that.
struct LatticeStrips {
  LatticeCorner tip, a, b;
  int halvings;

  /// Returns the corner of strip n, counted from the tip, on the long edge that ends at `end`.
  [[nodiscard]] LatticeCorner on_edge(const LatticeCorner& end, std::int32_t n) const {
    const auto between = [&](std::int64_t from, std::int64_t to) {
      return static_cast<std::int32_t>(from + (to - from) * n / (std::int64_t{1} << halvings));
    };
    return {between(tip.i, end.i), between(tip.j, end.j)};
  }
};

}  // namespace taxel
