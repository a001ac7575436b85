// Static trees with eight children per node in single precision, for traversal with SIMD: over any boxes, and
// over the facets of a rigid mesh. The exact tests that follow are in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

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

// The facets of a rigid mesh: its triangles, of which two that form a parallelogram are one facet. The diagonal of a
// face of a box, or of a strip of a cylinder, then divides no polygon of a contact surface.

/// Largest distance of a parallelogram's fourth corner from its place, as a fraction of the corners' largest
/// coordinate: four corners rounded to single precision, in which MuJoCo keeps meshes.
inline constexpr double kSameCorner = 2.4e-7;

/// The facets in the order of their tree, so that neighbours are close in memory.
class FacetTree {
 public:
  /// A triangle or a parallelogram.
  struct Facet {
    /// Indices in vertices(). The corners 0, 1, 2 of a triangle, and 0, 1, 3, 2 of a parallelogram, are
    /// counter-clockwise about the normal. Corner 3 is corner 1 + corner 2 - corner 0, up to kSameCorner.
    std::array<std::int32_t, 4> vertex{};
    int corners = 3;
    std::int32_t face = -1;  ///< face of the mesh, of a parallelogram the one with the lower number
    dvec3 normal{0};         ///< outward unit normal of that face
  };
  FacetTree() = default;
  explicit FacetTree(const TriMesh& mesh);

  [[nodiscard]] const WideBvh& tree() const { return tree_; }  ///< tree whose items are indices of facets
  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }
  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }

 private:
  WideBvh tree_;
  std::vector<Facet> facets_;
  std::vector<dvec3> vertices_;
};

}  // namespace taxel
