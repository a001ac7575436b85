// Static trees with eight children per node in single precision, for traversal with SIMD. The exact tests that follow
// are in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace taxel {

inline constexpr std::size_t kWide = 8;

/// A tree over points. Each inner node has up to eight children, each leaf has one item, and the used lanes begin at 0.
struct WideTopology {
  /// Value of unused lanes. A child >= 0 is a node, another child < 0 is the item ~child.
  static constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::min();
  std::vector<std::array<std::int32_t, kWide>> nodes;  ///< nodes[0] is the root; children follow their parent
  std::vector<std::int32_t> order;                     ///< items in the order of traversal

  /// Builds the tree by splits at the median of the widest axis, three times per node. Deterministic. O(n log n).
  explicit WideTopology(std::span<const dvec3> centers);
};

/// A tree of boxes in single precision, relative to origin(), rounded outward.
class WideBvh {
 public:
  struct alignas(64) Node {
    std::array<std::array<float, kWide>, 3> lo, hi;  ///< limits for each axis; unused lanes are empty boxes
    std::array<std::int32_t, kWide> child;
  };
  WideBvh() = default;
  explicit WideBvh(std::span<const Aabb> boxes);
  WideBvh(std::span<const Aabb> boxes, const WideTopology& topology);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const dvec3& origin() const { return origin_; }  ///< middle of all boxes
  [[nodiscard]] double size() const { return size_; }            ///< diagonal of all boxes [m]

 private:
  std::vector<Node> nodes_;
  dvec3 origin_{0};
  double size_ = 0;
};

}  // namespace taxel
