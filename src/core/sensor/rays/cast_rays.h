// First hits of the sensor's rays on its contact surfaces, by three ways that give the same bits.
//
// bvh: one BLAS per surface, a TLAS over them, built anew in each step; for any surface. tet_table: each polygon is
// tested against the rays that cross its tet, listed once (tet_table.h); for polygons that lie in the tets of the
// sensor's own field. A step's cost is then proportional to the contact: no structure is built, no ray is cast. Depth
// pieces lie in no tet, and go through trees of their own.
// raster: each polygon is tested against the rays under its projection (ray_grid.h); for rays of one direction, as flat
// arrays have them, and any surface.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/mesh/query/bvh.h"
#include "core/sensor/rays/edge_planes.h"
#include "core/sensor/rays/ray_hits.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Acceleration structures, kept between steps: per surface a BLAS, turned so that its third axis is the surface's mean
/// normal (a contact patch is flat, and so are its boxes then); over them a TLAS. Leaves are tested in frame M.
class SurfaceCaster {
 public:
  /// Surfaces in frame M; null or empty ones hold nothing. They must outlive the casts. Keeps the memory of the last
  /// build, so that no step allocates once the largest surface was seen.
  /// Polygons in tets of `table` are left out, unless it is null.
  void build(std::span<const ContactSurface* const> surfaces, const TetTable* table = nullptr);

  /// First hit with depth in [0, max_depth]; ties go to the lower surface, then the lower polygon.
  [[nodiscard]] RayHit cast(const dvec3& origin, const dvec3& direction, double max_depth) const;

  /// False only where the segment cannot meet any surface: a few comparisons that spare most rays the walk.
  [[nodiscard]] bool may_hit(const dvec3& from, const dvec3& to) const;

  [[nodiscard]] bool empty() const { return instances_.empty(); }
  /// Of all trees of the last build: as many as there are to visit.
  [[nodiscard]] std::size_t node_count() const;

 private:
  struct Instance {
    int surface = 0;
    Aabb box;               // frame M
    dmat3 axes{1.0};        // of the BLAS, in its columns: p_B = p_M * axes
    double lo = 0, hi = 0;  // of the surface along the third axis [m]
  };
  void add_instance(std::size_t number, const TetTable* table);

  std::vector<const ContactSurface*> surfaces_;
  std::vector<Bvh> blas_;                       // of surface i; more than surfaces_ where earlier steps had more
  std::vector<std::vector<EdgePlane>> planes_;  // likewise: of surface i, one per vertex
  std::vector<std::vector<int>> polygons_;      // of surface i, those in its BLAS; as long as blas_
  Bvh tlas_;
  std::vector<Instance> instances_;  // TLAS primitives: the surfaces that are not empty
  std::vector<Aabb> boxes_;
};

/// Offers the first hit of every ray of the model.
void cast_rays(const SensorModel& model, const SurfaceCaster& caster, RayHits& hits);

enum class RayPath {
  fastest,  ///< raster where the model has a grid, else tet_table
  bvh,
  tet_table,
  raster
};

/// What casting needs from step to step.
struct CastWorkspace {
  SurfaceCaster caster;
  std::vector<const ContactSurface*> others;  ///< by surface number; null: cast without trees
  CastBuffers buffers;
};

/// The first hits of all rays on all surfaces (frame M; null or empty ones hold nothing). With RayPath::tet_table the
/// surfaces must come from model.body as body A; polygons in no tet of it, and all where the model has no table, go
/// through trees; so does all with RayPath::raster where the model has no grid. No step allocates once the largest
/// surface was seen.
void cast_rays(const SensorModel& model, std::span<const ContactSurface* const> surfaces, RayPath path,
               CastWorkspace& workspace, RayHits& hits);

}  // namespace taxel
