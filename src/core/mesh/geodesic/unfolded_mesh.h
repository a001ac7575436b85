// A mesh prepared for unfolding: each triangle in a plane frame of each of its edges, and the angles around vertices.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A triangle laid flat on one of its edges, which runs from (0, 0) to (length, 0) with the third corner above it.
struct FlatEdge {
  double length = 0;   ///< length of the edge [m]
  dvec2 apex{0};       ///< third corner [m]
  dvec2 to_apex{0};    ///< unit vector from the edge's start to the apex
  dvec2 from_apex{0};  ///< unit vector from the apex to the edge's end
  int twin = -1;       ///< the edge in the face across, or -1 if the surface ends there
  int apex_fan = -1;   ///< fan of the apex in VertexFans
};

/// Half-edge h = 3 face + c runs from corner c of the face to corner c + 1. Vertices are the fans of faces around them:
/// where an edge is not an inner one (EdgeKind), or fans touch in one vertex, the mesh is cut open and no path passes.
/// Immutable; O(n).
class UnfoldedMesh {
 public:
  explicit UnfoldedMesh(TriMeshPtr mesh);

  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const FlatEdge& edge(int halfedge) const { return edges_[static_cast<std::size_t>(halfedge)]; }
  [[nodiscard]] int edge_count() const { return static_cast<int>(edges_.size()); }
  /// The fans at both ends of a half-edge, stored together so that one memory access finds them.
  struct Ends {
    int start = -1, end = -1;
  };
  [[nodiscard]] const Ends& ends(int halfedge) const { return ends_[static_cast<std::size_t>(halfedge)]; }

  struct Fan {
    double angle = 0;    ///< sum of the angles of its faces [rad]
    bool closed = true;  ///< true for a ring of faces, false for a row from boundary to boundary
    int first = 0;       ///< the fan has corners()[first .. first + count), counter-clockwise
    int count = 0;
    /// Shortest paths may bend here: at saddles and at the boundary (Mitchell, Mount, Papadimitriou 1987, lemma 3.4).
    [[nodiscard]] bool bends() const { return !closed || angle > 2.0 * kPi; }
  };
  [[nodiscard]] const Fan& fan(int fan) const { return fans_[static_cast<std::size_t>(fan)]; }
  [[nodiscard]] int fan_count() const { return static_cast<int>(fans_.size()); }
  /// Half-edges that begin at the vertex of a fan, one per face.
  [[nodiscard]] const std::vector<int>& corners() const { return corners_; }
  /// The angle at the apex of a half-edge between the first edge of the apex's fan and the half-edge's face [rad].
  [[nodiscard]] double angle_before(int halfedge) const { return angles_[static_cast<std::size_t>(halfedge)].x; }
  /// The angle of the half-edge's face at the apex [rad].
  [[nodiscard]] double apex_angle(int halfedge) const { return angles_[static_cast<std::size_t>(halfedge)].y; }

  /// Returns a point of the half-edge's face in the flat frame of the half-edge.
  [[nodiscard]] dvec2 flat(int halfedge, const dvec3& p) const;

 private:
  void lay_flat();
  void measure_fans();

  TriMeshPtr mesh_;
  std::vector<FlatEdge> edges_;
  std::vector<Ends> ends_;
  std::vector<Fan> fans_;
  std::vector<int> corners_;
  std::vector<dvec2> angles_;
};

}  // namespace taxel
