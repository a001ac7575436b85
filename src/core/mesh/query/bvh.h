// Bounding volume hierarchy over boxes: binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume
// Hierarchies"). The tree knows boxes only; what a leaf holds is tested by the caller's function.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace taxel {

struct Ray {
  dvec3 origin{0};
  dvec3 direction{0, 0, 1};  ///< unit
  double t_max = std::numeric_limits<double>::infinity();
};

class Bvh {
 public:
  struct Node {
    Aabb box;
    std::int32_t first = 0;  ///< leaf: first item of items(); inner: index of the left child, the right one follows it
    std::int32_t count = 0;  ///< leaf: number of items; inner: 0
    [[nodiscard]] bool leaf() const { return count > 0; }
  };

  /// No path from the root is longer, whatever the boxes: traversals need no growing stack.
  static constexpr int kMaxDepth = 96;

  Bvh() = default;
  /// Builds over primitives given by their boxes. Deterministic; no primitive is lost, whatever its box.
  explicit Bvh(std::span<const Aabb> boxes, int max_leaf = 4) { build(boxes, max_leaf); }
  /// Builds again; keeps the memory of the last build.
  void build(std::span<const Aabb> boxes, int max_leaf = 4);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }          ///< nodes()[0] is the root
  [[nodiscard]] const std::vector<std::int32_t>& items() const { return items_; }  ///< primitive numbers, in leaf order

  /// Calls test(primitive) for every primitive whose leaf box satisfies box_test(box) along with all boxes above.
  template <class BoxTest, class Test>
  void visit(const BoxTest& box_test, const Test& test) const;

  /// Front-to-back walk. test(primitive, t_max) returns the new t_max (unchanged where it missed). Boxes whose entry
  /// equals t_max are still visited, so that ties can go to the lowest number. Returns the last t_max.
  template <class Test>
  double cast(const Ray& ray, const Test& test) const;

 private:
  struct Split;
  [[nodiscard]] Split best_split(std::span<const Aabb> boxes, const Node& node) const;
  template <int kMostBins>
  void try_axis(std::span<const Aabb> boxes, const Node& node, int axis, const dvec3& lo, const dvec3& hi,
                Split& best) const;
  std::int32_t partition(std::span<const Aabb> boxes, const Node& node, const Split& split);

  std::vector<Node> nodes_;
  std::vector<std::int32_t> items_;
};

}  // namespace taxel

#include "core/mesh/query/bvh_inl.h"
