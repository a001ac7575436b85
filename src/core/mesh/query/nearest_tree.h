// A tree of boxes for nearest-point queries, with four children per node whose distances are computed together.
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
class NearestTree {
 public:
  NearestTree() = default;
  /// `boxes` are those of the primitives of `tree` [m].
  NearestTree(const Bvh& tree, std::span<const Aabb> boxes);

  /// Calls test(primitive) for each primitive whose box may be within `reach` of p [m], roughly from near to far.
  /// test returns the reach for the rest of the search.
  template <class Test>
  void visit(const dvec3& p, double reach, Test&& test) const;

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
  int near_children(const Node& node, const std::array<float, 3>& q, float error, float limit,
                    std::array<Waiting, kWidth>& found) const;
  [[nodiscard]] float squared_limit(double reach) const;

  std::vector<Node> nodes_;
  dvec3 origin_{0};
  double scale_ = 1;  ///< factor that makes boxes of size 1, whose squares fit a float
};

}  // namespace taxel
