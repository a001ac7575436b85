// A compact tree of boxes with four children per node, which queries test together.
#pragma once

#include <array>
#include <cstdint>
#include <span>
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

}  // namespace taxel

#include "core/mesh/query/box_tree_inl.h"
