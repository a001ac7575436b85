// The samples of one taxel with their shares of its reading.
#pragma once

#include <vector>

#include "core/sensor/rays/cast_rays.h"

namespace taxel {

/// One sample of a taxel in one step.
struct TaxelSampleReading {
  int sample = 0;         ///< index in SensorModel::samples
  bool hit = false;       ///< true if the ray hit a contact surface
  double depth = 0.0;     ///< depth of the hit along the ray; 0 for a miss [m]
  double pressure = 0.0;  ///< 0 for a miss [Pa]
  double weight = 0.0;    ///< weight in the receptive field [m^2]
  double share = 0.0;     ///< fraction of the taxel's reading; all are 0 if it reads 0
};

/// Returns the samples of one taxel for the layout's aggregate, sorted by sample. Throws Error for an unknown taxel.
std::vector<TaxelSampleReading> samples_behind(const SensorModel& model, const std::vector<RayHit>& hits, int taxel);

}  // namespace taxel
