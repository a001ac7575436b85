#include "core/sim/compare/error_bars.h"

#include "core/base/error.h"

namespace taxel {

ErrorBars::ErrorBars(const std::shared_ptr<const SimScene>& scene, Progress* progress) {
  for (std::size_t s = 0; s < scene->sensors.size(); ++s) {
    const SensorModelPtr& model = scene->sensors[s];
    OfSensor& one = sensors_.emplace_back();
    if (model == nullptr || model->layout.taxels.empty()) {
      one.missing = "it has no taxels";
      continue;
    }
    try {
      if (SamplingError::takes_samples(model->layout.readout)) {
        one.sampling = std::make_unique<SamplingError>(model);
      } else {
        one.tessellation = std::make_unique<TessellationError>(scene, s, progress);
      }
    } catch (const Error& e) {
      one.missing = e.message();
    }
  }
}

std::string ErrorBars::missing(std::size_t sensor) const {
  return sensors_.at(sensor).missing;
}

std::vector<double> ErrorBars::measure(const StepView& step, std::size_t sensor) {
  const OfSensor& one = sensors_.at(sensor);
  if (one.tessellation != nullptr) return one.tessellation->bars(step);
  if (one.sampling == nullptr) throw Error("sensor without error bars: " + one.missing);
  const SensorView& view = step.sensors[sensor];
  one.sampling->measure(view.surfaces, view.hits, view.readings);
  return one.sampling->bars();
}

}  // namespace taxel
