// The rays that cross each tet of a sensor's pressure field. They are found once, because rays are fixed in the
// sensor's frame. A contact polygon is in one tet, and only rays that cross this tet can hit it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/query/bvh.h"
#include "core/sensor/rays/ray_target.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

/// Finds the tets that rays cross. Tets are enlarged by the distance that contact polygons may reach beyond them, which
/// comes from rounding, merged vertices and kRimReach.
class TetCrossings {
 public:
  explicit TetCrossings(const PressureField& field);  ///< `field` must outlive this object

  /// Replaces `found` by the tets that `ray` crosses up to its depth, ascending.
  void find(const SensorRay& ray, std::vector<std::int32_t>& found) const;

 private:
  [[nodiscard]] double width(const Tet& tet) const;
  [[nodiscard]] bool crosses(int number, const SensorRay& ray) const;

  const PressureField& field_;
  Bvh tree_;
  double coordinates_ = 0, widest_ = 0;
};

/// The table.
class TetTable {
 public:
  TetTable() = default;
  TetTable(const PressureField& field, std::span<const SensorRay> rays);
  /// `crossings` has the tets that each ray crosses, ascending.
  TetTable(const PressureField& field, std::span<const SensorRay> rays,
           std::span<const std::span<const std::int32_t>> crossings) {
    fill(field.tets().size(), rays, crossings);
  }

  [[nodiscard]] int tet_count() const { return static_cast<int>(tets_.size()); }
  [[nodiscard]] bool has(int tet) const { return tet >= 0 && tet < tet_count(); }
  /// Returns the rays that cross a tet, ascending.
  [[nodiscard]] std::span<const RayTile> rays_of(int tet) const {
    const TetRays& rays = tets_[static_cast<std::size_t>(tet)];
    return {tiles_.data() + rays.first_tile, rays.tiles};
  }
  [[nodiscard]] const RayView& view_of(int tet) const { return tets_[static_cast<std::size_t>(tet)].view; }
  [[nodiscard]] std::size_t bytes() const { return tiles_.size() * sizeof(RayTile) + tets_.size() * sizeof(TetRays); }

 private:
  void fill(std::size_t tets, std::span<const SensorRay> rays,
            std::span<const std::span<const std::int32_t>> crossings);
  void set(std::size_t tet, std::span<const SensorRay> rays, std::span<const std::int32_t> crossing);

  struct alignas(64) TetRays {
    RayView view;
    std::uint32_t first_tile = 0, tiles = 0;
  };
  std::vector<TetRays> tets_;
  std::vector<RayTile> tiles_;  // tet by tet, so that the rays of neighbouring polygons stay in the caches
};

/// Offers the hits of all rays of the table on the polygons of one surface that are in a tet of the table. Returns
/// false if the surface has other polygons, such as depth pieces.
bool cast_through_tets(const TetTable& table, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits);

}  // namespace taxel
