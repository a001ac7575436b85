// The requested and the computed readings of a contact by other models; see core/sensor/compare.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/sensor/compare/reading_models.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui {

/// A sensor of the simulation in the displayed step, or in all recorded steps if the simulation does not run.
struct ModelsRequest {
  int sensor = 0;
  bool operator==(const ModelsRequest&) const = default;
};

/// The readings of one step by all models.
struct ComparedStep {
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< time [s] and travel [m] of the step
  ModelReadings readings;
};

struct ComparedSteps {
  int sensor = 0;
  SensorModelPtr model;             ///< sensor model that read the steps
  std::vector<ComparedStep> steps;  ///< compared steps, ascending
  std::size_t due = 0;              ///< number of steps once the comparison is complete
  std::string problem;              ///< reason why there are no steps; empty if there are or will be
  /// Returns the readings of a step, or null if the step is not among the compared steps.
  [[nodiscard]] const ComparedStep* at(std::uint64_t step) const {
    for (const ComparedStep& s : steps)
      if (s.step == step) return &s;
    return nullptr;
  }
};
using ComparedPtr = std::shared_ptr<const ComparedSteps>;

struct ModelsState {
  ComparedPtr compared;             ///< comparison of the selected sensor, or null
  unsigned hidden = 0;              ///< one bit per model whose curve is not drawn
  const void* curves_of = nullptr;  ///< comparison that `x` and `y` were computed from
  int taxel = -1;                   ///< index of the taxel with the curves, or -1
  std::vector<double> x;
  std::vector<std::vector<double>> y;  ///< curve of each model, as fractions of the curve's peak
};

}  // namespace taxel::ui
