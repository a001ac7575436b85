// First hits of the sensor's rays on its contact surfaces, by four paths that give the same bits.
//
// bvh: one BLAS per surface and a TLAS over them, rebuilt in each step; for any surface.
// tet_table: each polygon is tested against the rays that cross its tet, which are listed once (tet_table.h); for
// polygons in the tets of the sensor's own field. Other polygons, such as depth pieces, are tested against the rays of
// tiles near them (ray_tiles.h). tiles: all polygons are; for any surface, and for rigid sensors. The cost of a step is
// proportional to the contact: no tree is built and no ray is cast. raster: each polygon is tested against the rays
// under its projection (ray_grid.h); for rays of one direction, as in flat arrays, and any surface.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

class SurfaceCaster;
struct CastBuffers;

/// A way to find the hits. All ways give the same bits.
enum class RayPath {
  fastest,  ///< raster if the model has a grid, otherwise tet_table
  bvh,
  tet_table,
  tiles,
  raster
};

/// Scratch memory of casting, reused from step to step.
struct CastWorkspace {
  CastWorkspace();
  CastWorkspace(const CastWorkspace&) : CastWorkspace() {}  ///< copies no content
  ~CastWorkspace();
  std::unique_ptr<SurfaceCaster> caster;
  std::unique_ptr<CastBuffers> buffers;
  std::vector<const ContactSurface*> others;  ///< surfaces for the trees; null for others
};

/// Finds the first hits of all rays on all surfaces (frame M; null ones are empty). With RayPath::tet_table the
/// surfaces must come from model.body as body A. Polygons in none of its tets go through tiles. All polygons for which
/// the model lacks the table, grid or tiles of the path go through trees. Does not allocate after the largest surface.
void cast_rays(const SensorModel& model, std::span<const ContactSurface* const> surfaces, RayPath path,
               CastWorkspace& workspace, RayHits& hits);

}  // namespace taxel
