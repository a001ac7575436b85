// Bounding volume hierarchy over boxes: binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume
// Hierarchies"). The tree has boxes only; the caller's function tests the primitives of a leaf.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
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

/// Slab test of one ray against many boxes (Kay, Kajiya 1986). Zero direction components give infinite reciprocals;
/// an origin on a slab's plane then gives 0 * inf = NaN, which every comparison below ignores.
class SlabTest {
 public:
  explicit SlabTest(const Ray& ray) : origin_(ray.origin), inverse_(1.0 / ray.direction) {}

  /// Returns the distance at which the ray enters or touches the box, or infinity if it misses or enters beyond
  /// `t_max`.
  [[nodiscard]] double entry(const Aabb& box, double t_max) const {
    double enter = 0.0, leave = t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const bool backward = inverse_[axis] < 0;
      const double near_plane = ((backward ? box.hi[axis] : box.lo[axis]) - origin_[axis]) * inverse_[axis];
      const double far_plane = ((backward ? box.lo[axis] : box.hi[axis]) - origin_[axis]) * inverse_[axis] * kRoundUp;
      if (near_plane > enter) enter = near_plane;
      if (far_plane < leave) leave = far_plane;
    }
    return enter <= leave * kRoundUp ? enter : kMiss;
  }
  /// Returns true if an entry found earlier is now beyond `t_max`.
  [[nodiscard]] static bool beyond(double entry, double t_max) { return entry > t_max * kRoundUp; }
  static constexpr double kMiss = std::numeric_limits<double>::infinity();

  /// Increases a distance by a few roundings, so that a box whose edge the ray touches is not missed (Ize 2013).
  static constexpr double kRoundUp = 1.0 + 8.0 * std::numeric_limits<double>::epsilon();

 private:
  dvec3 origin_, inverse_;
};

template <class BoxTest, class Test>
void Bvh::visit(const BoxTest& box_test, const Test& test) const {
  if (nodes_.empty()) return;
  std::array<std::int32_t, kMaxDepth> stack;  // NOLINT: filled as it is used
  int size = 0;
  stack[static_cast<std::size_t>(size++)] = 0;
  while (size > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[static_cast<std::size_t>(--size)])];
    if (!box_test(node.box)) continue;
    if (node.leaf()) {
      for (std::int32_t i = 0; i < node.count; ++i) test(items_[static_cast<std::size_t>(node.first + i)]);
    } else {
      stack[static_cast<std::size_t>(size++)] = node.first + 1;
      stack[static_cast<std::size_t>(size++)] = node.first;
    }
  }
}

template <class Test>
double Bvh::cast(const Ray& ray, const Test& test) const {
  double t_max = ray.t_max;
  if (nodes_.empty()) return t_max;
  const SlabTest slabs(ray);
  struct Waiting {  // not a pair, whose constructor would zero kMaxDepth of them for every ray
    std::int32_t node;
    double entry;
  };
  std::array<Waiting, kMaxDepth> stack;  // NOLINT: filled as it is used
  int size = 0;
  const double root_entry = slabs.entry(nodes_[0].box, t_max);
  if (root_entry < SlabTest::kMiss) stack[static_cast<std::size_t>(size++)] = {0, root_entry};
  while (size > 0) {
    const auto [index, entry] = stack[static_cast<std::size_t>(--size)];
    if (SlabTest::beyond(entry, t_max)) continue;  // an equal entry is visited: a tie may go to a lower number
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.leaf()) {
      for (std::int32_t i = 0; i < node.count; ++i)
        t_max = test(items_[static_cast<std::size_t>(node.first + i)], t_max);
      continue;
    }
    Waiting nearer{node.first, 0}, farther{node.first + 1, 0};
    nearer.entry = slabs.entry(nodes_[static_cast<std::size_t>(nearer.node)].box, t_max);
    farther.entry = slabs.entry(nodes_[static_cast<std::size_t>(farther.node)].box, t_max);
    if (farther.entry < nearer.entry) std::swap(nearer, farther);
    if (farther.entry < SlabTest::kMiss) stack[static_cast<std::size_t>(size++)] = farther;
    if (nearer.entry < SlabTest::kMiss) stack[static_cast<std::size_t>(size++)] = nearer;
  }
  return t_max;
}

}  // namespace taxel
