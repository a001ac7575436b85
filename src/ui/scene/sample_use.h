// Use of a sample by its taxels.
#pragma once

#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

struct SampleUse {
  int taxel = 0;         ///< index in layout order
  double distance = 0;   ///< distance by the layout's metric [m]
  double angle_deg = 0;  ///< angle of its normal and that of the taxel or nearest subtaxel
  double weight = 0;     ///< weight in the reading [m^2]
};

/// Returns the uses of a sample, the nearest taxel first; empty if no taxel uses the sample.
std::vector<SampleUse> uses_of_sample(const SensorModel& model, int sample);

}  // namespace taxel::ui
