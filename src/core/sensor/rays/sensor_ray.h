// The rays of a sensor: fixed segments in its frame.
#pragma once

#include "core/base/math.h"

namespace taxel {

/// The ray of one used sample: from the skin inward. Frame M. One cache line: rays are read out of order.
struct alignas(64) SensorRay {
  int sample = 0;        ///< index in SensorModel::samples
  dvec3 origin{0};       ///< sample; of a rigid sensor 1e-6 of the mesh size outside
  dvec3 direction{0};    ///< unit, opposite to the surface normal (or to the taxel's)
  double max_depth = 0;  ///< readout.max_depth, or half the way to the opposite skin [m]
};

}  // namespace taxel
