// A mesh prepared for unfolding: every triangle laid flat on each of its edges, and the faces in turn around each
// vertex.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A triangle laid flat on one of its edges, which runs from (0, 0) to (length, 0) with the third corner above it.
struct FlatEdge {
  double length = 0;   ///< [m]
  dvec2 apex{0};       ///< third corner [m]
  dvec2 to_apex{0};    ///< unit vector from the edge's start to the apex
  dvec2 from_apex{0};  ///< unit vector from the apex to the edge's end
  int twin = -1;       ///< the same edge as the face across has it; -1 at a boundary
  int apex_fan = -1;   ///< the apex as a vertex, see UnfoldedMesh
};

/// Half-edge h = 3 face + c runs from corner c of the face to corner c + 1. Vertices are the fans of faces around them:
/// where the mesh is no orientable manifold (more than two faces at an edge, faces that wind differently, fans that
/// touch in one vertex) it is cut open, as HalfEdges does it, and a path cannot pass. Immutable; O(n log n).
class UnfoldedMesh {
 public:
  explicit UnfoldedMesh(TriMeshPtr mesh);

  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const FlatEdge& edge(int halfedge) const { return edges_[static_cast<std::size_t>(halfedge)]; }
  [[nodiscard]] int edge_count() const { return static_cast<int>(edges_.size()); }
  /// The vertices at the ends of a half-edge, as fans; here beside each other for a single look.
  struct Ends {
    int start = -1, end = -1;
  };
  [[nodiscard]] const Ends& ends(int halfedge) const { return ends_[static_cast<std::size_t>(halfedge)]; }

  struct Fan {
    double angle = 0;    ///< sum of the angles of its faces [rad]
    bool closed = true;  ///< a ring of faces; otherwise a row, counter-clockwise from boundary to boundary
    int first = 0;       ///< its faces: corners()[first .. first + count), counter-clockwise
    int count = 0;
    /// Shortest paths may bend here: at saddles and at the boundary (Mitchell, Mount, Papadimitriou 1987, lemma 3.4).
    [[nodiscard]] bool bends() const { return !closed || angle > 2.0 * kPi; }
  };
  [[nodiscard]] const Fan& fan(int fan) const { return fans_[static_cast<std::size_t>(fan)]; }
  [[nodiscard]] int fan_count() const { return static_cast<int>(fans_.size()); }
  /// Half-edges that begin at the vertex of a fan, one per face.
  [[nodiscard]] const std::vector<int>& corners() const { return corners_; }
  /// Directions at the apex of a half-edge, as angles counter-clockwise from the first edge of its fan: where the
  /// half-edge's face begins, and how wide it is [rad].
  [[nodiscard]] double angle_before(int halfedge) const { return angles_[static_cast<std::size_t>(halfedge)].x; }
  [[nodiscard]] double apex_angle(int halfedge) const { return angles_[static_cast<std::size_t>(halfedge)].y; }

  /// A point of the half-edge's face in the flat frame of the half-edge.
  [[nodiscard]] dvec2 flat(int halfedge, const dvec3& p) const;

 private:
  void lay_flat();
  void join_twins();
  void walk_fans();

  TriMeshPtr mesh_;
  std::vector<FlatEdge> edges_;
  std::vector<Ends> ends_;
  std::vector<Fan> fans_;
  std::vector<int> corners_;
  std::vector<dvec2> angles_;
};

/// The half-edges after and before h around its face.
inline int next_edge(int h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
inline int previous_edge(int h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

}  // namespace taxel
