// Numbers about a compiled layout that are always visible: coverage, overlap, and how well taxels fit the skin.
#pragma once

#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::ui {

struct ModelSummary {
  SensorModelPtr model;                 ///< model that the numbers describe, or null
  int used_samples = 0;                 ///< samples in at least one receptive field
  int shared_samples = 0;               ///< samples in more than one receptive field
  double skin_area = 0, used_area = 0;  ///< areas of the skin and of its used samples [m^2]
  std::vector<int> samples_of_taxel;
  std::vector<double> distance_to_skin;   ///< distance of each taxel's centre to the skin [m]
  std::vector<double> angle_to_skin_deg;  ///< angle of each normal to the skin's at the nearest point
};

/// Returns the numbers about a model. Costs O(samples + taxels * log faces).
ModelSummary summarize(const SensorModelPtr& model);

}  // namespace taxel::ui
