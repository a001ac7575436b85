// An immutable triangle mesh with what every user of it needs: normals, areas, volume, connected shells.
#pragma once

#include <memory>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Triangles over shared vertices, metres, outward = counter-clockwise. Built once, never changed.
class TriMesh {
 public:
  /// Takes vertices (finite) and faces (indices in range, three different corners, positive area): what the
  /// loaders and makers of this folder guarantee. Throws Error naming the first face that breaks this.
  /// `flat_faces`: faces without area between the same vertices (flat_faces()).
  TriMesh(std::vector<dvec3> vertices, std::vector<ivec3> faces, std::vector<ivec3> flat_faces = {});

  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<ivec3>& faces() const { return faces_; }
  /// Faces of the file that have no area, between vertices of other faces. They are no part of the surface, and nothing
  /// but repair uses them: they join faces that would be torn apart without them.
  [[nodiscard]] const std::vector<ivec3>& flat_faces() const { return flat_faces_; }
  [[nodiscard]] int vertex_count() const { return static_cast<int>(vertices_.size()); }
  [[nodiscard]] int face_count() const { return static_cast<int>(faces_.size()); }
  [[nodiscard]] const dvec3& vertex(int face, int corner) const {
    return vertices_[static_cast<std::size_t>(faces_[static_cast<std::size_t>(face)][corner])];
  }

  [[nodiscard]] const std::vector<dvec3>& face_normals() const { return face_normals_; }      ///< unit
  [[nodiscard]] const std::vector<double>& face_areas() const { return face_areas_; }         ///< m^2
  [[nodiscard]] const std::vector<dvec3>& vertex_normals() const { return vertex_normals_; }  ///< unit, angle weighted
  /// Connected shell of each face (faces that share a vertex); shells are numbered by their first face.
  [[nodiscard]] const std::vector<int>& shell_of_face() const { return shell_of_face_; }
  [[nodiscard]] int shell_count() const { return shell_count_; }

  [[nodiscard]] const Aabb& bounds() const { return bounds_; }
  [[nodiscard]] double area() const { return area_; }      ///< of all faces [m^2]
  [[nodiscard]] double volume() const { return volume_; }  ///< signed, by the divergence theorem [m^3]
  [[nodiscard]] const dvec3& centroid() const {
    return centroid_;
  }  ///< of the volume; of the area where open or flat [m]
  /// Every edge belongs to exactly two faces of opposite direction.
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  void compute_normals();
  void compute_integrals();
  [[nodiscard]] dvec3 area_centroid() const;

  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_, flat_faces_;
  std::vector<dvec3> face_normals_, vertex_normals_;
  std::vector<double> face_areas_;
  std::vector<int> shell_of_face_;
  int shell_count_ = 0;
  Aabb bounds_;
  double area_ = 0, volume_ = 0;
  dvec3 centroid_{0};
  bool closed_ = false;
};

using TriMeshPtr = std::shared_ptr<const TriMesh>;

/// The faces of one shell (or of several), with unused vertices dropped. Face order is kept.
/// `face_of` (optional) gets, for each new face, its index in `mesh`.
TriMesh extract_shells(const TriMesh& mesh, const std::vector<int>& shells, std::vector<int>* face_of = nullptr);
/// These faces and their vertices, both in the order in which they are named.
TriMesh extract_faces(const TriMesh& mesh, const std::vector<int>& faces);

/// Whether `shell` lies inside another shell (a cavity when it is oriented inward).
bool shell_is_enclosed(const TriMesh& mesh, int shell);

/// The shells that touch the outside: all that are not enclosed by another one. Sensing uses these.
std::vector<int> outer_shells(const TriMesh& mesh);

}  // namespace taxel
