// A compact tree of boxes with four children per node, which queries test together.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "core/mesh/query/bvh.h"

namespace taxel {

/// A Bvh with two levels folded into one and a leaf for each primitive (Dammertz, Hanika, Keller 2008, "Shallow
/// Bounding Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent Rays"). Boxes are single precision and rounded
/// outward: a query skips only primitives that are too far, and the caller measures the others.
class BoxTree {
 public:
  BoxTree() = default;
  /// Builds a tree over primitives given by their boxes [m], none of which is empty.
  explicit BoxTree(std::span<const Aabb> boxes, Bvh::Effort effort = Bvh::Effort::many_queries);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }

  /// Calls test(primitive) for each primitive whose box may be within `reach` of p [m], roughly from near to far.
  /// test returns the reach for the rest of the search.
  template <class Test>
  void visit_near(const dvec3& p, double reach, Test&& test) const;

  /// Calls test(primitive) for each primitive whose box may overlap `box` [m], in no particular order. A test that
  /// returns true ends the visit; it may return nothing.
  template <class Test>
  void visit_overlapping(const Aabb& box, Test&& test) const;

  /// The number of nodes. Each primitive is in the leaves of one of them.
  [[nodiscard]] int node_count() const { return static_cast<int>(nodes_.size()); }
  /// Primitives that are next to each other: the leaves of a node, at most four.
  struct Leaves {
    std::array<std::int32_t, 4> primitives;
    int count = 0;
  };
  [[nodiscard]] Leaves leaves_of(int node) const;

  /// Traverses front to back, as Bvh::cast does: test(primitive, t_max) returns the new t_max, unchanged if the ray
  /// misses the primitive, and boxes whose entry equals t_max are still visited. Returns the last t_max.
  template <class Test>
  double cast(const Ray& ray, Test&& test) const;

 private:
  static constexpr int kWidth = 4;
  /// One number of each child: a vector that fits a register of every processor.
  using Lanes [[gnu::vector_size(kWidth * sizeof(float))]] = float;
  struct alignas(64) Node {  // two cache lines
    std::array<Lanes, 3> lo, hi;
    std::array<std::int32_t, kWidth> child;  ///< number of a node, or ~primitive
    std::int32_t count;
  };
  struct Waiting {
    float squared_distance;
    std::int32_t child;
  };
  struct Entered {
    double entry;  ///< distance at which a ray enters the box, scaled like the boxes
    std::int32_t child;
  };
  /// Any box scaled like those of the tree and rounded outward.
  struct LocalBox {
    std::array<float, 3> lo, hi;
  };
  struct LocalRay {
    dvec3 origin, inverse;  ///< inverse direction; infinite where that is zero
    double error;           ///< largest rounding of the origin
  };
  /// A future child: a node of the binary tree with the number of its parts, or ~primitive.
  struct Entry {
    Aabb box;
    std::int32_t child;
    int parts;
  };
  struct Entries {
    std::array<Entry, kWidth> list;
    int count = 0;
    void add(const Entry& entry) { list[static_cast<std::size_t>(count++)] = entry; }
  };

  static Entries below(const Bvh& tree, std::span<const Aabb> boxes, std::int32_t binary);
  std::int32_t add(const Bvh& tree, std::span<const Aabb> boxes, std::int32_t binary);
  [[nodiscard]] LocalBox local_box(const Aabb& box) const;
  int near_children(const Node& node, const std::array<float, 3>& q, float error, float limit,
                    std::array<Waiting, kWidth>& found) const;
  static int entered_children(const Node& node, const LocalRay& ray, double limit, std::array<Entered, kWidth>& found);
  [[nodiscard]] float squared_limit(double reach) const;

  std::vector<Node> nodes_;
  dvec3 origin_{0};
  double scale_ = 1;  ///< factor that makes boxes of size 1, whose squares fit a float
};

/// Finds the children that may be within the limit, nearest first.
inline int BoxTree::near_children(const Node& node, const std::array<float, 3>& q, float error, float limit,
                                  std::array<Waiting, kWidth>& found) const {
  Lanes sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Lanes below = node.lo[axis] - q[axis], above = q[axis] - node.hi[axis];
    const Lanes outside = (below > above ? below : above) - error;
    const Lanes least = outside > 0.0f ? outside : Lanes{};
    sum += least * least;
  }
  int size = 0;
  for (int i = 0; i < node.count; ++i) {
    const float d2 = sum[i];
    if (d2 > limit) continue;
    int to = size++;
    for (; to > 0 && found[static_cast<std::size_t>(to - 1)].squared_distance > d2; --to)
      found[static_cast<std::size_t>(to)] = found[static_cast<std::size_t>(to - 1)];
    found[static_cast<std::size_t>(to)] = {d2, node.child[static_cast<std::size_t>(i)]};
  }
  return size;
}

/// Returns a limit above scale^2 reach^2 by more than the rounding errors of near_children.
inline float BoxTree::squared_limit(double reach) const {
  constexpr double kRoundings = 16 * std::numeric_limits<float>::epsilon();
  const double local = scale_ * reach;
  return static_cast<float>((1 + kRoundings) * local * local);
}

template <class Test>
void BoxTree::visit_near(const dvec3& p, double reach, Test&& test) const {
  if (nodes_.empty()) return;
  const dvec3 local = scale_ * (p - origin_);
  const std::array<float, 3> q{static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z)};
  // Twice the largest rounding of p.
  const double size = std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)});
  const auto error = static_cast<float>(std::numeric_limits<float>::epsilon() * size);
  float limit = squared_limit(reach);
  std::array<Waiting, (kWidth - 1) * Bvh::kMaxDepth + 1> stack;  // NOLINT: filled as it is used
  std::array<Waiting, kWidth> found;                             // NOLINT
  std::size_t waiting = 0;
  stack[waiting++] = {0.0f, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared_distance > limit) continue;
    const int size_found = near_children(nodes_[static_cast<std::size_t>(next.child)], q, error, limit, found);
    for (int i = 0; i < size_found; ++i) {
      const Waiting& leaf = found[static_cast<std::size_t>(i)];
      if (leaf.child < 0 && !(leaf.squared_distance > limit)) limit = squared_limit(test(~leaf.child));
    }
    for (int i = size_found - 1; i >= 0; --i) {
      const Waiting& inner = found[static_cast<std::size_t>(i)];
      if (inner.child >= 0 && !(inner.squared_distance > limit)) stack[waiting++] = inner;
    }
  }
}

template <class Test>
void BoxTree::visit_overlapping(const Aabb& box, Test&& test) const {
  if (nodes_.empty()) return;
  const LocalBox q = local_box(box);
  std::array<std::int32_t, (kWidth - 1) * Bvh::kMaxDepth + 1> stack;  // NOLINT: filled as it is used
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--waiting])];
    auto overlap = (node.lo[0] <= q.hi[0]) & (node.hi[0] >= q.lo[0]);
    for (std::size_t axis = 1; axis < 3; ++axis)
      overlap &= (node.lo[axis] <= q.hi[axis]) & (node.hi[axis] >= q.lo[axis]);
    for (int i = 0; i < node.count; ++i) {
      if (overlap[i] == 0) continue;
      const std::int32_t child = node.child[static_cast<std::size_t>(i)];
      if (child >= 0) {
        stack[waiting++] = child;
      } else if constexpr (std::is_void_v<decltype(test(~child))>) {
        test(~child);
      } else if (test(~child)) {
        return;
      }
    }
  }
}

/// Finds the children whose boxes the ray enters within the limit, nearest first: the test of SlabTest for all boxes of
/// a node at once. The boxes are widened by the rounding of the ray's origin.
inline int BoxTree::entered_children(const Node& node, const LocalRay& ray, double limit,
                                     std::array<Entered, kWidth>& found) {
  using Doubles [[gnu::vector_size(kWidth * sizeof(double))]] = double;
  Doubles enter{}, leave = limit - Doubles{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int component = static_cast<int>(axis);
    const double origin = ray.origin[component], inverse = ray.inverse[component];
    const Doubles lo = (__builtin_convertvector(node.lo[axis], Doubles) - ray.error - origin) * inverse;
    const Doubles hi = (__builtin_convertvector(node.hi[axis], Doubles) + ray.error - origin) * inverse;
    const Doubles near_plane = inverse < 0 ? hi : lo;
    const Doubles far_plane = (inverse < 0 ? lo : hi) * SlabTest::kRoundUp;
    enter = near_plane > enter ? near_plane : enter;  // false for NaN
    leave = far_plane < leave ? far_plane : leave;
  }
  int size = 0;
  for (int i = 0; i < node.count; ++i) {
    const double entry = enter[i];
    if (!(entry <= leave[i] * SlabTest::kRoundUp)) continue;
    int to = size++;
    for (; to > 0 && found[static_cast<std::size_t>(to - 1)].entry > entry; --to)
      found[static_cast<std::size_t>(to)] = found[static_cast<std::size_t>(to - 1)];
    found[static_cast<std::size_t>(to)] = {entry, node.child[static_cast<std::size_t>(i)]};
  }
  return size;
}

template <class Test>
double BoxTree::cast(const Ray& ray, Test&& test) const {
  double t_max = ray.t_max;
  if (nodes_.empty()) return t_max;
  const dvec3 from = scale_ * (ray.origin - origin_);
  const double size = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
  const LocalRay local{from, 1.0 / ray.direction, 4 * std::numeric_limits<double>::epsilon() * size};
  std::array<Entered, (kWidth - 1) * Bvh::kMaxDepth + 1> stack;  // NOLINT: filled as it is used
  std::array<Entered, kWidth> found;                             // NOLINT
  std::size_t waiting = 0;
  stack[waiting++] = {0, 0};
  while (waiting > 0) {
    const Entered next = stack[--waiting];
    if (SlabTest::beyond(next.entry, scale_ * t_max)) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.child)];
    const int size_found = entered_children(node, local, scale_ * t_max, found);
    for (int i = 0; i < size_found; ++i) {
      const Entered& leaf = found[static_cast<std::size_t>(i)];
      if (leaf.child < 0 && !SlabTest::beyond(leaf.entry, scale_ * t_max)) t_max = test(~leaf.child, t_max);
    }
    for (int i = size_found - 1; i >= 0; --i) {
      const Entered& inner = found[static_cast<std::size_t>(i)];
      if (inner.child >= 0) stack[waiting++] = inner;
    }
  }
  return t_max;
}

}  // namespace taxel
