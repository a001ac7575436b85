// Finds the tets of a pressure field that a ray crosses.
#pragma once

#include <cstdint>
#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/query/bvh.h"
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

}  // namespace taxel
