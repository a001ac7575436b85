// Static trees of eight children per node, single precision: what SIMD walks. The exact tests that follow are in
// double.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

inline constexpr std::size_t kWide = 8;

/// A tree over points: each inner node has up to eight children, all leaves hold one item, and lanes fill from 0.
struct WideTopology {
  /// Children of a node: >= 0 another node, < 0 the item ~child. Unused lanes: kNone.
  static constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::min();
  std::vector<std::array<std::int32_t, kWide>> nodes;  ///< nodes[0] is the root; children follow their parent
  std::vector<std::int32_t> order;                     ///< items as a walk meets them

  /// Splits at medians of the widest axis, three times per node. Deterministic. O(n log n).
  explicit WideTopology(std::span<const dvec3> centers);
};

/// Boxes in single precision, relative to origin(), rounded outward.
class WideBvh {
 public:
  struct alignas(64) Node {
    std::array<std::array<float, kWide>, 3> lo, hi;  ///< by axis; unused lanes are empty boxes
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

/// The triangles of a mesh in the order of their tree: neighbours lie side by side in memory.
class TriangleTree {
 public:
  struct Triangle {
    std::array<std::int32_t, 3> vertex;  ///< indices in vertices()
    std::int32_t face = -1;              ///< face of the mesh
    dvec3 normal{0};                     ///< unit, outward
  };
  TriangleTree() = default;
  explicit TriangleTree(const TriMesh& mesh);

  [[nodiscard]] const WideBvh& tree() const { return tree_; }  ///< its items number `triangles`
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }

 private:
  WideBvh tree_;
  std::vector<Triangle> triangles_;
  std::vector<dvec3> vertices_;
};

}  // namespace taxel
