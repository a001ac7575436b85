// Builds our fingertip with its twelve taxels for benchmarks.
#pragma once

#include "core/sensor/sensor_model.h"

namespace taxel::bench {

/// Returns the model with about `samples` samples, whatever density this needs.
inline SensorModelPtr our_fingertip(double samples) {
  SensorSource source = read_sensor_source(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
  source.layout.sampling.density *= samples / static_cast<double>(build_sensor_model(source)->samples.size());
  return build_sensor_model(source);
}

}  // namespace taxel::bench
