// Traversals of Bvh. Included by bvh.h.
#pragma once

#include <array>
#include <utility>

namespace taxel {

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
