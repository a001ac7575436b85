// The nearest point of a triangle mesh, by BVH; and ray hits on it.
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/query/bvh.h"
#include "core/mesh/query/nearest_tree.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SurfacePoint {
  dvec3 position{0};
  int face = -1;
  dvec3 barycentric{0};  ///< weights of the face's corners, sum 1
  double distance = 0;   ///< from the query point, unsigned [m]
};

/// A nearest point, and on which side of the mesh the query lies.
struct SignedPoint {
  SurfacePoint point;
  double signed_distance = 0;  ///< negative inside [m]
};

struct MeshHit {
  double t = 0;  ///< distance along the ray [m]
  int face = -1;
  dvec3 barycentric{0};
};

/// A mesh with its BVH. Immutable; safe to share between threads.
class MeshIndex {
 public:
  explicit MeshIndex(TriMeshPtr mesh);
  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const TriMeshPtr& mesh_ptr() const { return mesh_; }
  [[nodiscard]] const Bvh& bvh() const { return bvh_; }

  /// Nearest point; ties go to the lowest face number. O(log n), less where it is known to lie `within` some distance;
  /// where none does, the face is -1.
  [[nodiscard]] SurfacePoint closest_point(const dvec3& p,
                                           double within = std::numeric_limits<double>::infinity()) const;
  /// First hit from either side (ray_triangle.h: watertight, no epsilon); ties go to the lowest face number.
  [[nodiscard]] std::optional<MeshHit> cast(const Ray& ray) const;
  /// Like cast, leaving out one face (rays that start on it).
  [[nodiscard]] std::optional<MeshHit> cast_except(const Ray& ray, int face) const;
  /// Inside test by the sign of the angle-weighted pseudonormal at the nearest point (Baerentzen, Aanaes 2005);
  /// meaningful for closed meshes.
  [[nodiscard]] SignedPoint signed_point(const dvec3& p, double within = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] double signed_distance(const dvec3& p) const { return signed_point(p).signed_distance; }

 private:
  TriMeshPtr mesh_;
  Bvh bvh_;
  NearestTree tree_;
  std::vector<dvec3> edge_normals_;    ///< pseudonormal of the edge from corner c to c + 1 at 3 face + c
  std::vector<double> normal_errors_;  ///< how far rounding may turn each face's normal; large for needles
};

}  // namespace taxel
