// Where a reading comes from: the samples behind one taxel, with their part of it.
#pragma once

#include <vector>

#include "core/sensor/rays/cast_rays.h"

namespace taxel {

struct TaxelSampleReading {
  int sample = 0;         ///< in SensorModel::samples
  bool hit = false;       ///< whether the ray met a contact surface
  double depth = 0.0;     ///< along the ray; 0 for a miss [m]
  double pressure = 0.0;  ///< 0 for a miss [Pa]
  double weight = 0.0;    ///< of the receptive field [m^2]
  double share = 0.0;     ///< part of the taxel's reading that this sample makes; all sum to 1 (to 0 where it reads 0)
};

/// The row of one taxel for the aggregate of the layout, sorted by sample number. Throws Error for an unknown taxel.
std::vector<TaxelSampleReading> samples_behind(const SensorModel& model, const std::vector<RayHit>& hits, int taxel);

}  // namespace taxel
