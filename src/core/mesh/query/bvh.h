// Bounding volume hierarchy over boxes: binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume
// Hierarchies"). The tree has boxes only; the caller's function tests the primitives of a leaf.
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
    std::int32_t first = 0;  ///< first entry of items() of a leaf; left child of an inner node
    std::int32_t count = 0;  ///< number of items of a leaf; 0 for an inner node, whose right child is first + 1
    [[nodiscard]] bool leaf() const { return count > 0; }
  };

  /// Largest length of a path from the root for any boxes, so that traversals have a stack of fixed size.
  static constexpr int kMaxDepth = 96;

  /// Whether a tree is worth a long build.
  enum class Effort {
    many_queries,  ///< all axes are tried, and leaves are split if their parts cost queries less
    few_queries    ///< only the longest axis is tried, and leaves are full: two thirds of the time
  };

  Bvh() = default;
  /// Builds a tree over primitives given by their boxes. Deterministic; no primitive is lost, even if its box is empty.
  explicit Bvh(std::span<const Aabb> boxes, int max_leaf = 4) { build(boxes, max_leaf); }
  /// Rebuilds the tree in the memory of the last build.
  void build(std::span<const Aabb> boxes, int max_leaf = 4, Effort effort = Effort::many_queries);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }          ///< nodes()[0] is the root
  [[nodiscard]] const std::vector<std::int32_t>& items() const { return items_; }  ///< primitive numbers, in leaf order

  /// Calls test(primitive) for every primitive whose leaf box satisfies box_test(box) along with all boxes above.
  template <class BoxTest, class Test>
  void visit(const BoxTest& box_test, const Test& test) const;

  /// Traverses front to back. test(primitive, t_max) returns the new t_max, unchanged if the ray misses the primitive.
  /// Boxes whose entry equals t_max are still visited, so that ties can go to the lowest number. Returns the last
  /// t_max.
  template <class Test>
  double cast(const Ray& ray, const Test& test) const;

 private:
  struct Split;
  struct Parts;
  /// A node that may be split. `keys` bounds twice the centres of its boxes.
  struct Pending {
    std::int32_t node;
    int depth;
    Aabb keys;
  };
  [[nodiscard]] Split best_split(std::span<const Aabb> boxes, const Node& node, Aabb keys, Effort effort) const;
  static void split_pair(const Aabb& first, const Aabb& second, const Node& node, const Aabb& keys, Split& best);
  template <int kMost>
  struct Bins;
  template <int kMost>
  void try_axes(std::span<const Aabb> boxes, const Node& node, const Aabb& keys, Effort effort, Split& best) const;
  Parts partition(std::span<const Aabb> boxes, const Node& node, const Split& split);

  std::vector<Node> nodes_;
  std::vector<std::int32_t> items_;
};

}  // namespace taxel

#include "core/mesh/query/bvh_inl.h"
