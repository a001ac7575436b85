// Error bars of the readings of all sensors of a scene.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/run/recording/run_recorder.h"
#include "core/run/scene.h"
#include "core/run/step.h"
#include "core/sensor/compare.h"
#include "core/sensor/error_bars.h"

namespace taxel {

/// Measures the error bars of one sensor of a scene: readings that are made of samples against their integral
/// (SamplingError), and readings that are integrals against a finer tessellation. So a bar says how far the next better
/// computation of the same contact is. May be used by one thread at a time.
///
/// The bars of a finer tessellation are
///
///   bar = 4/3 |reading - reading with edges half as long|    (richardson_bars())
///
/// Both readings have the same samples. All bodies are finer: the sensor's own, other sensors, and geoms, soft or
/// rigid. In steps that were saved by a version that did not write the shapes of soft geoms, these keep their
/// tessellation.
class SensorErrors {
 public:
  /// Computes the integrals' fields, or builds the finer bodies. Throws Error if the readings have no bars
  /// (SamplingError::why_none()), the scene does not know the bodies that are touched, or a finer body cannot be built.
  /// Throws Cancelled.
  SensorErrors(const SimScene& scene, std::size_t sensor, Progress* progress = nullptr);

  /// Returns the readings of a step of the scene, the better ones (ReadingModel::exact or ReadingModel::finer), and the
  /// bars. The result depends on `step` only. Throws Error if a contact cannot be computed again.
  [[nodiscard]] ModelReadings read(const StepView& step);

 private:
  void make_finer_bodies(const SimScene& scene, Progress* progress);

  std::size_t sensor_;
  std::unique_ptr<SamplingError> sampling_;  // null for readings that are integrals
  SensorModelPtr finer_;
  std::vector<TouchedBody> touched_;  // finer bodies, parallel to SimScene::touched of the sensor
};

/// The error bars of all sensors of a scene.
class ErrorBars : public ErrorBarSource {
 public:
  /// Prepares the bars of each sensor. Throws Cancelled.
  explicit ErrorBars(const std::shared_ptr<const SimScene>& scene, Progress* progress = nullptr);

  [[nodiscard]] std::string missing(std::size_t sensor) const override;
  /// Throws Error for a sensor without error bars, or if a contact cannot be computed again.
  std::vector<double> measure(const StepView& step, std::size_t sensor) override;

 private:
  /// The measure of a sensor, or the reason why there is none.
  struct OfSensor {
    std::unique_ptr<SensorErrors> errors;
    std::string missing;
  };
  std::vector<OfSensor> sensors_;
};

}  // namespace taxel
