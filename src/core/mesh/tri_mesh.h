// An immutable triangle mesh with its normals, areas, volume, shells and edges, parts of it, and its cut with a plane.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/math.h"

namespace taxel {

// The half-edges of a triangle mesh: twins, edges, fans of faces around vertices, boundary loops, faulty edges.
//
//        c          A face (a, b, c) has the half-edges a -> b, b -> c and c -> a, counter-clockwise. The half-edge
//       / \         3 face + corner begins at that corner. Its twin is the same edge in the face across, where it
//      /   \        runs the other way. The half-edges that begin at one vertex form fans: each is a row or a ring
//     a --> b       of faces, every one joined to the next by twins.

/// The half-edge after h around its face.
inline int next_edge(int h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
/// The half-edge before h around its face.
inline int previous_edge(int h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// The faces at an edge: only an inner edge joins its faces.
enum class EdgeKind {
  inner,        ///< two faces that pass the edge in opposite directions
  boundary,     ///< one face
  misoriented,  ///< two faces that pass the edge in the same direction
  nonmanifold   ///< more than two faces
};

/// Fans of faces around vertices, numbered by their lowest half-edge.
struct VertexFans {
  std::vector<int> fan_of;   ///< fan at the vertex where each half-edge begins
  std::vector<int> corners;  ///< half-edges that begin at the vertex, counter-clockwise, fan after fan
  std::vector<int> first;    ///< index in `corners` of each fan's first half-edge, and the end of the last fan

  [[nodiscard]] int count() const { return static_cast<int>(first.size()) - 1; }
  [[nodiscard]] std::span<const int> corners_of(int fan) const {
    const auto f = static_cast<std::size_t>(fan);
    return std::span(corners).subspan(static_cast<std::size_t>(first[f]),
                                      static_cast<std::size_t>(first[f + 1] - first[f]));
  }
};

/// Connectivity of any triangles, manifold or not. At a boundary, misoriented or nonmanifold edge the surface ends: its
/// half-edges have no twin. Immutable; O(n log n) for n faces, in practice linear.
class EdgeTopology {
 public:
  EdgeTopology() = default;
  /// Each face has three different vertices below `vertex_count`.
  EdgeTopology(std::vector<ivec3> faces, std::size_t vertex_count);

  [[nodiscard]] const std::vector<ivec3>& faces() const { return faces_; }
  [[nodiscard]] int half_edge_count() const { return static_cast<int>(twins_.size()); }
  /// The vertex where a half-edge begins.
  [[nodiscard]] int from(int h) const { return faces_[static_cast<std::size_t>(h / 3)][h % 3]; }
  /// The vertex where a half-edge ends.
  [[nodiscard]] int to(int h) const { return from(next_edge(h)); }
  /// The lower of the two vertices of a half-edge.
  [[nodiscard]] int low(int h) const { return std::min(from(h), to(h)); }
  /// The higher of the two vertices of a half-edge.
  [[nodiscard]] int high(int h) const { return std::max(from(h), to(h)); }
  /// Returns true if a half-edge runs from its lower vertex to its higher one.
  [[nodiscard]] bool is_forward(int h) const { return from(h) < to(h); }
  /// The twin of a half-edge, or -1 if the surface ends there.
  [[nodiscard]] int twin(int h) const { return twins_[static_cast<std::size_t>(h)]; }
  /// The face across a half-edge, or -1 if the surface ends there.
  [[nodiscard]] int face_across(int h) const { return twin(h) < 0 ? -1 : twin(h) / 3; }
  /// Returns true if there are faces and each half-edge has a twin.
  [[nodiscard]] bool is_closed() const { return closed_; }

  [[nodiscard]] int edge_count() const { return static_cast<int>(first_.size()) - 1; }
  /// All half-edges of an edge in the order of their faces. Edges are in the order of (low, high).
  [[nodiscard]] std::span<const int> edge(int e) const {
    const int *begin = half_edges_.data() + first_[static_cast<std::size_t>(e)],
              *end = half_edges_.data() + first_[static_cast<std::size_t>(e) + 1];
    return {begin, end};
  }
  /// Calls body(half-edges of one edge) for every edge in order.
  template <class Body>
  void for_each_edge(const Body& body) const {
    for (int e = 0; e < edge_count(); ++e) body(edge(e));
  }
  /// The half-edges of the edge between two vertices, or none if there is no such edge. O(log n).
  [[nodiscard]] std::span<const int> edge_between(int a, int b) const;
  /// The kind of an edge, given its half-edges.
  [[nodiscard]] EdgeKind kind(std::span<const int> edge) const;
  /// The edges of one kind in order, each as its half-edges.
  [[nodiscard]] std::vector<std::span<const int>> edges_of(EdgeKind kind) const;

  /// Walks around every vertex. O(n).
  [[nodiscard]] VertexFans vertex_fans() const;
  /// Vertices with more than one fan, ascending. O(n).
  [[nodiscard]] std::vector<int> nonmanifold_vertices() const;
  /// The half-edges without a twin as closed loops, each continued at its end by the next one around the same fan, in
  /// the order of their lowest half-edges. Holes lie to the right. O(n).
  [[nodiscard]] std::vector<std::vector<int>> boundary_loops() const;

 private:
  std::vector<ivec3> faces_;
  std::vector<int> half_edges_;  ///< by edge
  std::vector<int> first_{0};    ///< for each edge, its first index in half_edges_; then the total number
  std::vector<int> twins_;
  bool closed_ = false;
};

/// Triangles over shared vertices in metres, counter-clockwise seen from outside. Immutable.
class TriMesh {
 public:
  /// Vertices must be finite; faces must have indices in range, three different corners and a positive area.
  /// `flat_faces` are those of flat_faces(). Throws Error naming the first vertex or face that breaks this.
  TriMesh(std::vector<dvec3> vertices, std::vector<ivec3> faces, std::vector<ivec3> flat_faces = {});

  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<ivec3>& faces() const { return topology_.faces(); }
  /// Twins, edges and fans of the faces.
  [[nodiscard]] const EdgeTopology& topology() const { return topology_; }
  /// Faces of the file that have no area, between vertices of other faces. They are not part of the surface. Only
  /// repair uses them: they join faces that would be torn apart without them.
  [[nodiscard]] const std::vector<ivec3>& flat_faces() const { return flat_faces_; }
  [[nodiscard]] int vertex_count() const { return static_cast<int>(vertices_.size()); }
  [[nodiscard]] int face_count() const { return static_cast<int>(faces().size()); }
  [[nodiscard]] const dvec3& vertex(int face, int corner) const {
    return vertices_[static_cast<std::size_t>(faces()[static_cast<std::size_t>(face)][corner])];
  }

  [[nodiscard]] const std::vector<dvec3>& face_normals() const { return face_normals_; }  ///< unit
  [[nodiscard]] const std::vector<double>& face_areas() const { return face_areas_; }     ///< m^2
  /// Unit normals of the vertices: the face normals weighted by the angles of the faces at the vertex.
  [[nodiscard]] const std::vector<dvec3>& vertex_normals() const { return vertex_normals_; }
  /// Connected shell of each face (faces that share a vertex); shells are numbered by their first face.
  [[nodiscard]] const std::vector<int>& shell_of_face() const { return shell_of_face_; }
  [[nodiscard]] int shell_count() const { return shell_count_; }

  [[nodiscard]] const Aabb& bounds() const { return bounds_; }
  [[nodiscard]] double area() const { return area_; }      ///< area of all faces [m^2]
  [[nodiscard]] double volume() const { return volume_; }  ///< signed volume by the divergence theorem [m^3]
  /// Centroid of the volume, or of the area if the mesh is open or flat [m].
  [[nodiscard]] const dvec3& centroid() const { return centroid_; }
  /// Returns true if there are faces and each edge belongs to exactly two of them, in opposite directions.
  [[nodiscard]] bool closed() const { return topology_.is_closed(); }

 private:
  void compute_normals();
  void compute_integrals();
  [[nodiscard]] dvec3 area_centroid() const;

  std::vector<dvec3> vertices_;
  std::vector<ivec3> flat_faces_;
  EdgeTopology topology_;
  std::vector<dvec3> face_normals_, vertex_normals_;
  std::vector<double> face_areas_;
  std::vector<int> shell_of_face_;
  int shell_count_ = 0;
  Aabb bounds_;
  double area_ = 0, volume_ = 0;
  dvec3 centroid_{0};
};

using TriMeshPtr = std::shared_ptr<const TriMesh>;

/// Returns the faces of some shells in their order, without unused vertices. `face_of` (optional) gets the index in
/// `mesh` of each new face. Throws Error for a number that is no shell.
TriMesh extract_shells(const TriMesh& mesh, const std::vector<int>& shells, std::vector<int>* face_of = nullptr);
/// Returns some faces with their vertices, both in the order of `faces`.
TriMesh extract_faces(const TriMesh& mesh, const std::vector<int>& faces);

/// Returns true if another shell encloses `shell`. An enclosed shell that is oriented inward is a cavity.
bool shell_is_enclosed(const TriMesh& mesh, int shell);

/// Returns the shells that no other shell encloses, ascending. Sensing uses these.
std::vector<int> outer_shells(const TriMesh& mesh);

/// Cuts a mesh for a section view: returns one segment for each face that intersects the plane through `point` with
/// this normal (any length > 0), in the order of faces. Each segment has the body on its left, seen against the normal.
/// Segments of neighbouring faces have ends that are equal bit by bit, so the cut of a closed mesh consists of closed
/// loops. A vertex on the plane is treated as above it: faces in the plane give no segment, but their neighbours do.
/// O(n).
std::vector<std::pair<dvec3, dvec3>> slice_mesh(const TriMesh& mesh, const dvec3& point, const dvec3& normal);

}  // namespace taxel
