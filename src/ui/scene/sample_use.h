// Use of a sample by its taxels.
#pragma once

#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

struct SampleUse {
  int taxel = 0;         ///< layout order
  double distance = 0;   ///< by the layout's metric [m]
  double angle_deg = 0;  ///< between its normal and the taxel's, or its nearest subtaxel's
  double weight = 0;     ///< in the reading [m^2]
};

/// Nearest taxel first; none where nobody uses it.
std::vector<SampleUse> uses_of_sample(const SensorModel& model, int sample);

}  // namespace taxel::ui
