// An immutable triangle mesh with its normals, areas, volume, shells and edges.
#pragma once

#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/topology/edge_topology.h"

namespace taxel {

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

}  // namespace taxel
