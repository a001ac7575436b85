// For each tet of a sensor's pressure field the rays that cross it: found once, for rays are fixed in the sensor's
// frame. A contact polygon lies in one tet, and only that tet's rays can meet it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/hydro/pressure_field.h"
#include "core/sensor/edge_lanes.h"
#include "core/sensor/ray_hits.h"
#include "core/sensor/ray_lanes.h"
#include "core/sensor/sensor_ray.h"
#include "core/sensor/tet_crossings.h"

namespace taxel {

class TetTable {
 public:
  TetTable() = default;
  TetTable(const PressureField& field, std::span<const SensorRay> rays);
  /// The same from crossings that are known: of each ray, tets ascending.
  TetTable(const PressureField& field, std::span<const SensorRay> rays,
           std::span<const std::span<const TetCrossing>> crossings) {
    fill(field.tets().size(), rays, crossings);
  }

  [[nodiscard]] int tet_count() const { return static_cast<int>(first_.size()) - 1; }
  [[nodiscard]] bool has(int tet) const { return tet >= 0 && tet < tet_count(); }
  /// The rays of a tet, ascending, are those of lanes() from `first` on, before `last`.
  struct Range {
    std::size_t first, last;
  };
  [[nodiscard]] Range rays_of(int tet) const {
    const auto t = static_cast<std::size_t>(tet);
    return {first_[t], first_[t + 1]};
  }
  /// Side by side, tet by tet: what few rays of few tets share stays in the caches.
  [[nodiscard]] RayLanes lanes() const { return rays_.lanes(); }
  [[nodiscard]] std::size_t bytes() const { return rays_.bytes() + first_.size() * sizeof(first_[0]); }

 private:
  void fill(std::size_t tets, std::span<const SensorRay> rays, std::span<const std::span<const TetCrossing>> crossings);

  std::vector<std::uint32_t> first_{0};
  RayList rays_;
};

/// Offers the hits of all rays on one surface, whose tets are those of the table. False where a polygon names none: the
/// surface is then for the trees, and what was offered so far is right but not all.
bool cast_through_tets(const TetTable& table, const ContactSurface& surface, int surface_number, EdgeLanes& edges,
                       RayHits& hits);

}  // namespace taxel
