// The rays of a sensor in tiles of neighbours, and a tree over the tiles, for polygons that are in no tet of the
// sensor: depth pieces, and all polygons of rigid sensors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/mesh/query/bvh.h"
#include "core/sensor/rays/ray_target.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

class TetTable;

/// The tiles.
class RayTiles {
 public:
  explicit RayTiles(std::span<const SensorRay> rays);

  /// Rays whose origins are neighbours. All of their points are within `reach` of the line through `origin` along
  /// `axis`.
  struct Group {
    RayView view;
    dvec3 origin{0}, axis{0, 0, 1};  ///< frame M; the axis is a unit vector
    double reach = 0;                ///< [m]
    RayTile tile;
  };
  [[nodiscard]] const Group& group(std::int32_t number) const { return groups_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] std::size_t group_count() const { return groups_.size(); }

  /// Replaces `found` by all groups with a ray that may hit the polygon.
  void find(const ContactSurface& surface, const ContactPolygon& polygon, std::vector<std::int32_t>& found) const;

 private:
  std::vector<Group> groups_;
  Bvh tree_;  ///< over the boxes of the groups' rays from origin to depth
};

/// Offers the hits of all rays on the polygons of one surface that are in no tet of `table`; on all of its polygons if
/// `table` is null.
void cast_through_tiles(const RayTiles& tiles, const TetTable* table, std::span<const SensorRay> rays,
                        const ContactSurface& surface, int surface_number, CastBuffers& buffers, RayHits& hits);

}  // namespace taxel
