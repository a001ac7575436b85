// First hits of rays on contact surfaces by trees: one BLAS per surface and a TLAS over them, rebuilt in each step.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/mesh/query/bvh.h"
#include "core/sensor/rays/ray_target.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

class TetTable;

/// The trees of RayPath::bvh, whose memory is reused from step to step: one BLAS per surface, whose third axis is the
/// surface's mean normal (a contact patch is flat, and so are its boxes then), and a TLAS. Leaves are tested in frame
/// M.
class SurfaceCaster {
 public:
  /// Builds the trees of surfaces in frame M, which must outlive the casts. Null surfaces are empty. Polygons in tets
  /// of `table` are excluded, unless it is null. Does not allocate after the largest surface.
  void build(std::span<const ContactSurface* const> surfaces, const TetTable* table = nullptr);

  /// Returns the first hit with depth in [0, max_depth]; of equal depths the lower surface, then the lower polygon.
  [[nodiscard]] RayHit cast(const dvec3& origin, const dvec3& direction, double max_depth) const;

  /// Returns false only if the segment surely misses all surfaces: a few comparisons, which save most rays the
  /// traversal.
  [[nodiscard]] bool may_hit(const dvec3& from, const dvec3& to) const;

  [[nodiscard]] bool empty() const { return instances_.empty(); }
  /// Returns the number of nodes of all trees of the last build.
  [[nodiscard]] std::size_t node_count() const;

 private:
  struct Instance {
    int surface = 0;
    Aabb box;               // frame M
    dmat3 axes{1.0};        // axes of the BLAS as columns: p_B = p_M * axes
    double lo = 0, hi = 0;  // range of the surface along the third axis [m]
  };
  void add_instance(std::size_t number, const TetTable* table);

  std::vector<const ContactSurface*> surfaces_;
  std::vector<Bvh> blas_;                       // tree of surface i; more than surfaces_ if earlier steps had more
  std::vector<std::vector<EdgePlane>> planes_;  // planes of surface i, one per vertex; as long as blas_
  std::vector<std::vector<int>> polygons_;      // polygons in the BLAS of surface i; as long as blas_
  Bvh tlas_;
  std::vector<Instance> instances_;  // TLAS primitives: the surfaces that are not empty
  std::vector<Aabb> boxes_;
};

}  // namespace taxel
