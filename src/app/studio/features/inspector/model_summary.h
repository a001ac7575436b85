// Numbers about a compiled layout that are always in sight: coverage, overlap, how well taxels sit on the skin.
#pragma once

#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

struct ModelSummary {
  SensorModelPtr model;                 ///< what the numbers are about; null: nothing yet
  int used_samples = 0;                 ///< in at least one receptive field
  int shared_samples = 0;               ///< in more than one
  double skin_area = 0, used_area = 0;  ///< [m^2]
  std::vector<int> samples_of_taxel;
  std::vector<double> distance_to_skin;   ///< of each centre [m]
  std::vector<double> angle_to_skin_deg;  ///< between each normal and the skin's at the nearest point
};

/// O(samples + taxels * log faces).
ModelSummary summarize(const SensorModelPtr& model);

}  // namespace taxel::ui
