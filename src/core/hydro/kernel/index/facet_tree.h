// The facets of a rigid mesh: its triangles, of which two that form a parallelogram are one facet. The diagonal of a
// face of a box, or of a strip of a cylinder, then divides no polygon of a contact surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hydro/kernel/index/wide_tree.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

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
