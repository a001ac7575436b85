#include "core/sensor/rays/cast_rays.h"

#include "core/sensor/rays/ray_grid.h"
#include "core/sensor/rays/ray_tiles.h"
#include "core/sensor/rays/surface_caster.h"
#include "core/sensor/rays/tet_table.h"

namespace taxel {
namespace {

/// Offers the first hit of every ray of the model to `hits`.
void cast_through_trees(const SensorModel& model, const SurfaceCaster& caster, RayHits& hits) {
  if (caster.empty()) return;
  for (std::size_t i = 0; i < model.rays.size(); ++i) {
    const SensorRay& ray = model.rays[i];
    if (!caster.may_hit(ray.origin, ray.origin + ray.max_depth * ray.direction)) continue;
    const RayHit hit = caster.cast(ray.origin, ray.direction, ray.max_depth);
    if (hit.hit()) hits.offer(static_cast<std::int32_t>(i), hit);
  }
}

}  // namespace

CastWorkspace::CastWorkspace() : caster(std::make_unique<SurfaceCaster>()), buffers(std::make_unique<CastBuffers>()) {}
CastWorkspace::~CastWorkspace() = default;

void cast_rays(const SensorModel& model, std::span<const ContactSurface* const> surfaces, RayPath path,
               CastWorkspace& workspace, RayHits& hits) {
  hits.clear(model.rays.size());
  workspace.others.assign(surfaces.begin(), surfaces.end());
  if (path == RayPath::fastest) path = model.ray_tables.grid ? RayPath::raster : RayPath::tet_table;
  const bool raster = path == RayPath::raster && model.ray_tables.grid;
  const bool through_tets = path == RayPath::tet_table && model.ray_tables.tets;
  const bool through_tiles = (path == RayPath::tet_table || path == RayPath::tiles) && model.ray_tables.tiles;
  for (std::size_t i = 0; i < surfaces.size() && (raster || through_tets || through_tiles); ++i) {
    if (!surfaces[i]) continue;
    const int number = static_cast<int>(i);
    CastBuffers& buffers = *workspace.buffers;
    bool is_done = raster;
    if (raster) cast_through_grid(*model.ray_tables.grid, model.rays, *surfaces[i], number, buffers, hits);
    if (through_tets)
      is_done = cast_through_tets(*model.ray_tables.tets, model.rays, *surfaces[i], number, buffers, hits);
    if (!is_done && through_tiles) {
      const TetTable* const table = through_tets ? model.ray_tables.tets.get() : nullptr;
      cast_through_tiles(*model.ray_tables.tiles, table, model.rays, *surfaces[i], number, buffers, hits);
      is_done = true;
    }
    if (is_done) workspace.others[i] = nullptr;
  }
  workspace.caster->build(workspace.others, through_tets ? model.ray_tables.tets.get() : nullptr);
  cast_through_trees(model, *workspace.caster, hits);
  hits.finish();
}

}  // namespace taxel
