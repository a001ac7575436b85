// Corners with integer coordinates, so that pieces of a facet share their corners exactly.
#pragma once

#include <array>
#include <cstdint>

namespace taxel {

struct LatticeCorner {
  std::int32_t i = 0, j = 0;
  bool operator==(const LatticeCorner&) const = default;
};

inline LatticeCorner middle(const LatticeCorner& a, const LatticeCorner& b) {
  return {(a.i + b.i) / 2, (a.j + b.j) / 2};
}

/// A triangle or a parallelogram, counter-clockwise.
struct LatticePolygon {
  std::array<LatticeCorner, 4> corner;
  int count = 3;  ///< number of corners
};

/// A triangle or a parallelogram with two long edges, cut across them:
///
///     tip --- 1 --- 2 --- 3 --- end of a     Each of the 2^halvings strips has parts of the two long edges as its
///       `---- 1 --- 2 --- 3 --- end of b     sides; strips are as long as the facet is wide, or up to half of that.
///
/// Both edges of a triangle begin at its tip, those of a parallelogram at two corners.
struct LatticeStrips {
  struct LongEdge {
    LatticeCorner begin, end;
  };
  /// Beginning and end of a, then end and beginning of b are counter-clockwise.
  LongEdge a, b;
  int halvings;

  [[nodiscard]] bool has_tip() const { return a.begin == b.begin; }
  /// Returns the corner of strip n, counted from the beginning, on a long edge.
  [[nodiscard]] LatticeCorner on(const LongEdge& edge, std::int32_t n) const {
    const auto between = [&](std::int64_t from, std::int64_t to) {
      return static_cast<std::int32_t>(from + (to - from) * n / (std::int64_t{1} << halvings));
    };
    return {between(edge.begin.i, edge.end.i), between(edge.begin.j, edge.end.j)};
  }
};

}  // namespace taxel
