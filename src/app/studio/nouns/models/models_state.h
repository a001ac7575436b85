// The requested and the computed readings of a contact by other models, see core/sensor/compare, and their panel.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "core/sensor/compare.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui {

/// A sensor of the simulation in the displayed step, or in all recorded steps if the simulation does not run.
struct ModelsRequest {
  int sensor = 0;
  bool operator==(const ModelsRequest&) const = default;
};

/// Steps of one sensor of a run, read by several models.
struct ComparedSteps {
  int sensor = 0;
  SensorModelPtr model;    ///< sensor model of the run
  ComparedStepList steps;  ///< compared steps, ascending
  std::size_t due = 0;     ///< number of steps once the comparison is complete
  std::string problem;     ///< reason why there are no readings; empty if there are or will be
  /// Returns the readings of a step, or null if the step is not among the compared steps.
  [[nodiscard]] const ComparedStep* at(std::uint64_t step) const {
    for (const ComparedStepPtr& s : steps)
      if (s->step == step) return s.get();
    return nullptr;
  }
};
using ComparedPtr = std::shared_ptr<const ComparedSteps>;

struct ModelsState {
  ComparedPtr compared;             ///< comparison of the selected sensor, or null
  const void* curves_of = nullptr;  ///< comparison that `x` and `y` were computed from
  int taxel = -1;                   ///< index of the taxel with the curves, or -1
  std::vector<double> x;
  std::vector<std::vector<double>> y;  ///< curve of each model, as fractions of the curve's peak
};

/// Returns the sensor to compare; empty if the panel is closed or no sensor is simulated.
[[nodiscard]] std::optional<ModelsRequest> models_request(const Viewer& viewer, const Shown& shown, bool open);

/// Returns the comparison of the selected sensor; null if there is none, or not yet.
[[nodiscard]] const ComparedSteps* shown_comparison(const Viewer& viewer, const Shown& shown, const ModelsState& models,
                                                    bool open);

/// Returns the index of the taxel whose curves are drawn: the active taxel, otherwise the taxel with the largest
/// reading; -1 if there is none.
[[nodiscard]] int compared_taxel(const Selection& selection, const ComparedSteps& compared);

/// The panel that compares readings of one contact by several models: a table of the displayed step, and curves over
/// the recorded steps.
extern const Feature kModels;
/// Sets "models": the readings at the displayed step, and their comparison over all steps that were read.
void dump_models(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_models_job(JobExecutor& executor);

}  // namespace taxel::studio
