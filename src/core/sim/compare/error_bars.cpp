#include "core/sim/compare/error_bars.h"

#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/sensor/error_bars.h"
#include "core/sim/compare/contact_again.h"

namespace taxel {

SensorErrors::SensorErrors(const SimScene& scene, std::size_t sensor, Progress* progress) : sensor_(sensor) {
  const SensorModelPtr& model = scene.sensors.at(sensor);
  if (SamplingError::takes_samples(model->layout.readout)) {
    sampling_ = std::make_unique<SamplingError>(model);
  } else {
    make_finer_bodies(scene, progress);
  }
}

void SensorErrors::make_finer_bodies(const SimScene& scene, Progress* progress) {
  if (const std::string missing = missing_touched(scene); !missing.empty()) throw Error(missing);
  finer_ = with_finer_body(scene.sensors[sensor_]);
  touched_ = scene.touched[sensor_];
  std::map<const Shape*, HydroBodyPtr> made;  // equal shapes are built once
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    TouchedBody& one = touched_[i];
    if (one.body == nullptr) continue;
    const SensorModelPtr partner = one.sensor >= 0 ? scene.sensors[static_cast<std::size_t>(one.sensor)] : nullptr;
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

ModelReadings SensorErrors::read(const StepView& step) {
  const SensorView& view = step.sensors.at(sensor_);
  ModelReadings out{{{ReadingModel::reading, {view.readings.begin(), view.readings.end()}, ""}}, {}};
  if (sampling_ != nullptr) {
    sampling_->measure(view.surfaces, view.hits, view.readings);
    out.models.push_back({ReadingModel::exact, sampling_->exact(), ""});
    out.bars = sampling_->bars();
    return out;
  }
  out.models.push_back(read_in_place(ReadingModel::finer, *finer_, touched_, step, sensor_));
  const ModelReading& finer = out.models.back();
  if (!finer.missing.empty()) throw Error(finer.missing);
  out.bars = richardson_bars(view.readings, finer.values);
  return out;
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
      one.errors = std::make_unique<SensorErrors>(*scene, s, progress);
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
  if (one.errors == nullptr) throw Error("sensor without error bars: " + one.missing);
  return one.errors->read(step).bars;
}

}  // namespace taxel
