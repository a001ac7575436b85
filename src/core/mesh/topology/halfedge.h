// Which face lies across which edge: a half-edge mesh, by OpenMesh.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// One edge of a mesh. Runs from a to b in its left face, counter-clockwise.
struct MeshEdge {
  int a = -1, b = -1;         ///< vertices
  int left = -1, right = -1;  ///< faces; right is -1 at a boundary
  double dihedral = 0;  ///< angle between the normals of the two faces [rad]; > 0 convex, < 0 concave, 0 at a boundary
};

/// An edge that a surface cannot have.
struct BadEdge {
  int a = -1, b = -1;      ///< vertices, a < b
  std::vector<int> faces;  ///< all at this edge
};

/// Edge adjacency of any triangle mesh. Where the mesh is no orientable manifold it is cut open: at edges with more
/// than two faces, at edges whose two faces wind differently, and at vertices where several fans of faces touch. The
/// cuts are listed.
class HalfEdges {
 public:
  explicit HalfEdges(const TriMesh& mesh);

  /// Face across the edge from corner c to corner c + 1 of a face, -1 where there is none.
  [[nodiscard]] int neighbour(int face, int corner) const {
    return neighbours_[static_cast<std::size_t>(face)][corner];
  }
  /// All edges; each once, and once per side where the mesh is cut.
  [[nodiscard]] const std::vector<MeshEdge>& edges() const { return edges_; }
  /// Directed edges a -> b of faces that have no other face there and lie on a true rim (not on a cut).
  [[nodiscard]] const std::vector<std::pair<int, int>>& boundary_edges() const { return boundary_; }
  [[nodiscard]] const std::vector<BadEdge>& nonmanifold_edges() const { return nonmanifold_; }  ///< > 2 faces
  [[nodiscard]] const std::vector<BadEdge>& misoriented_edges() const {
    return misoriented_;
  }  ///< 2 faces, same direction
  [[nodiscard]] const std::vector<int>& nonmanifold_vertices() const { return split_vertices_; }  ///< more than one fan
  /// Vertices joined to v by an edge, counter-clockwise seen from outside, beginning at a boundary where there is one;
  /// fan after fan at a non-manifold vertex.
  [[nodiscard]] const std::vector<int>& one_ring(int vertex) const { return rings_[static_cast<std::size_t>(vertex)]; }

 private:
  std::vector<ivec3> neighbours_;
  std::vector<MeshEdge> edges_;
  std::vector<std::pair<int, int>> boundary_;
  std::vector<BadEdge> nonmanifold_, misoriented_;
  std::vector<int> split_vertices_;
  std::vector<std::vector<int>> rings_;
};

}  // namespace taxel
