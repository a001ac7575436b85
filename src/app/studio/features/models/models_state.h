// What is asked of other models of a contact, and what they said: see core/sensor/compare.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/sensor/compare/reading_models.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui {

/// A sensor of the simulation, in the step that is shown; all recorded steps where the simulation does not run.
struct ModelsRequest {
  int sensor = 0;
  bool operator==(const ModelsRequest&) const = default;
};

/// One step as all models read it.
struct ComparedStep {
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< [s], [m]
  ModelReadings readings;
};

struct ComparedSteps {
  int sensor = 0;
  SensorModelPtr model;             ///< the layout that read them
  std::vector<ComparedStep> steps;  ///< ascending
  std::size_t due = 0;              ///< steps that there will be
  std::string problem;              ///< why there are none; empty: there are, or will be
  /// Null where the step is not among them.
  [[nodiscard]] const ComparedStep* at(std::uint64_t step) const {
    for (const ComparedStep& s : steps)
      if (s.step == step) return &s;
    return nullptr;
  }
};
using ComparedPtr = std::shared_ptr<const ComparedSteps>;

struct ModelsState {
  ComparedPtr compared;             ///< comparison of the selected sensor, or null
  unsigned hidden = 0;              ///< curves that are not drawn, by bit
  const void* curves_of = nullptr;  ///< what `x` and `y` are of
  int taxel = -1;                   ///< index
  std::vector<double> x;
  std::vector<std::vector<double>> y;  ///< by model, as parts of its peak
};

}  // namespace taxel::ui
