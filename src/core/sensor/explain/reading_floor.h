// Lower limit of the largest reading, used when a change is expressed as a fraction of the largest reading.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/base/math.h"
#include "core/layout/words.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the limit, in the unit of the readings: 1e-4 of the modulus, or, if readings are forces, this pressure times
/// the area of the largest receptive field. 0 for a rigid sensor. Every contact gives larger readings, so rounding
/// errors are not reported as jumps.
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
