// Least value of the largest reading when a change is measured as a fraction of it.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/base/math.h"
#include "core/layout/words.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns 1e-4 of the modulus, which is less than any contact of a sensor reads, so that rounding is not a jump. For
/// readings that are forces: that pressure times the largest receptive field. 0 for a rigid sensor. [unit of the
/// reading]
inline double reading_floor(const SensorModel& model) {
  constexpr double kFraction = 1e-4;
  const double pressure = kFraction * model.layout.material.modulus;
  const Aggregate how = model.layout.readout.aggregate;
  if (std::string_view(reading_unit(how)) == "Pa") return pressure;
  double radius = 0;
  for (const Taxel& taxel : model.layout.taxels) radius = std::max(radius, taxel.radius);
  return pressure * kPi * radius * radius;
}

}  // namespace taxel
