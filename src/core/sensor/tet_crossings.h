// Where a ray is inside of the tets of a pressure field.
#pragma once

#include <cstdint>
#include <vector>

#include "core/hydro/pressure_field.h"
#include "core/mesh/bvh.h"
#include "core/sensor/sensor_ray.h"

namespace taxel {

struct TetCrossing {
  std::int32_t tet = 0;
  double t_min = 0, t_max = 0;  ///< along the ray [m]
};

/// Finds the tets that rays cross. Tets are widened by what contact polygons may reach over them: rounding, merged
/// vertices, kRimReach.
class TetCrossings {
 public:
  explicit TetCrossings(const PressureField& field);  ///< keeps a reference

  /// Replaces `found` by what `ray` crosses up to its depth, tets ascending.
  void find(const SensorRay& ray, std::vector<TetCrossing>& found) const;

 private:
  [[nodiscard]] double width(const Tet& tet) const;
  void add(int number, const SensorRay& ray, std::vector<TetCrossing>& found) const;

  const PressureField& field_;
  Bvh tree_;
  double coordinates_ = 0, widest_ = 0;
};

}  // namespace taxel
