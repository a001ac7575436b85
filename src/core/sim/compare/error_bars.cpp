#include "core/sim/compare/error_bars.h"

#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/sensor/error_bars.h"
#include "core/sim/compare/contact_again.h"

namespace taxel {

TessellationError::TessellationError(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress)
    : scene_(std::move(scene)), sensor_(sensor) {
  if (scene_->touched.size() != scene_->sensors.size())
    throw Error("the step was read from a file of a version that left out the bodies that are touched");
  finer_ = with_finer_body(scene_->sensors.at(sensor_));
  touched_ = scene_->touched[sensor_];
  std::map<const Shape*, HydroBodyPtr> made;  // equal shapes are built once
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    TouchedBody& one = touched_[i];
    if (one.body == nullptr) continue;
    const SensorModelPtr partner = one.sensor >= 0 ? scene_->sensors[static_cast<std::size_t>(one.sensor)] : nullptr;
    if (partner != nullptr && !partner->layout.taxels.empty()) {
      one.body = with_finer_body(partner)->body;
    } else if (one.shape != nullptr) {
      HydroBodyPtr& body = made[one.shape.get()];
      if (body == nullptr) body = make_body(finer_shape(*one.shape, one.body->material), one.body->material, one.name);
      one.body = body;
    }
    if (progress != nullptr) progress->check(static_cast<double>(i + 1) / static_cast<double>(touched_.size()));
  }
}

std::vector<double> TessellationError::bars(const StepView& step) const {
  const SensorView& view = step.sensors.at(sensor_);
  std::vector<SensorStep> poses(step.sensors.size());
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].X_WM = step.sensors[i].X_WM;
  const TouchedPoses bodies = touched_poses(*scene_, sensor_, poses, step.geom_poses);
  if (!bodies.unknown.empty()) throw Error(bodies.unknown);
  return richardson_bars(view.readings, read_own_contact(*finer_, touched_, view.X_WM, bodies.X_WB));
}

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
