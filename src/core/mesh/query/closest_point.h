// Nearest points of a triangle mesh and ray hits on it, by a BVH.
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/query/box_tree.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SurfacePoint {
  dvec3 position{0};
  int face = -1;
  dvec3 barycentric{0};  ///< weights of the face's corners, sum 1
  double distance = 0;   ///< unsigned distance from the query point [m]
};

/// A nearest point with the side of the mesh on which the query is.
struct SignedPoint {
  SurfacePoint point;
  double signed_distance = 0;  ///< signed distance of the query, negative inside [m]
};

struct MeshHit {
  double t = 0;  ///< distance along the ray [m]
  int face = -1;
  dvec3 barycentric{0};
};

/// Returns the tree over the boxes of the faces.
BoxTree tree_of_faces(const TriMesh& mesh, Bvh::Effort effort = Bvh::Effort::many_queries);

/// A mesh with its BVH. Immutable; safe to share between threads.
class MeshIndex {
 public:
  explicit MeshIndex(TriMeshPtr mesh, Bvh::Effort effort = Bvh::Effort::many_queries);
  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const TriMeshPtr& mesh_ptr() const { return mesh_; }
  /// The tree over the boxes of the faces.
  [[nodiscard]] const BoxTree& tree() const { return tree_; }

  /// Returns the nearest point; ties go to the lowest face number. A limit `within` on the distance makes the search
  /// faster; the face is -1 if no point is within it, or farther by less than the rounding errors. O(log n).
  [[nodiscard]] SurfacePoint closest_point(const dvec3& p,
                                           double within = std::numeric_limits<double>::infinity()) const;
  /// Returns the faces whose boxes may be within `reach` of p [m], ascending.
  [[nodiscard]] std::vector<int> faces_near(const dvec3& p, double reach) const;
  /// Returns the first hit from either side (triangle.h: watertight, no epsilon); ties go to the lowest face
  /// number.
  [[nodiscard]] std::optional<MeshHit> cast(const Ray& ray) const;
  /// Returns the first hit on any face except one, for rays that start on that face.
  [[nodiscard]] std::optional<MeshHit> cast_except(const Ray& ray, int face) const;
  /// Returns the nearest point with its signed distance, by the angle-weighted pseudonormal there (Baerentzen, Aanaes
  /// 2005). The sign is meaningful for closed meshes.
  [[nodiscard]] SignedPoint signed_point(const dvec3& p, double within = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] double signed_distance(const dvec3& p) const { return signed_point(p).signed_distance; }
  /// Returns the nearest point of p with the signed distance of p from it.
  [[nodiscard]] SignedPoint with_sign(const dvec3& p, const SurfacePoint& nearest) const;
  /// Returns an upper bound of the rounding error of a face's unit normal.
  [[nodiscard]] float normal_error(int face) const { return normal_errors_[static_cast<std::size_t>(face)]; }

 private:
  TriMeshPtr mesh_;
  std::vector<float> normal_errors_;  ///< largest rounding of each face's normal; large for needles
  BoxTree tree_;
};

}  // namespace taxel
