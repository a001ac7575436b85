// The rays of a sensor: fixed segments in its frame.
#pragma once

#include "core/base/math.h"

namespace taxel {

/// The ray of one used sample: from the skin inward. Frame M. One cache line: rays are read out of order.
struct alignas(64) SensorRay {
  int sample = 0;        ///< in SensorModel::samples
  dvec3 origin{0};       ///< the sample; on a rigid sensor a millionth of the mesh's size outside of it
  dvec3 direction{0};    ///< unit, opposite to the surface normal (or to the taxel's)
  double max_depth = 0;  ///< allowed depth: readout.max_depth, cut half way to the opposite skin [m]
};

}  // namespace taxel
