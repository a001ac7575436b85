// Error bars of the readings of all sensors of a scene.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/run/recording/run_recorder.h"
#include "core/run/scene.h"
#include "core/run/step.h"
#include "core/sensor/error_bars.h"

namespace taxel {

/// The bodies of one sensor of a scene with edges half as long. May be used by one thread at a time.
///
///   bar = 4/3 |reading - reading with edges half as long|    (richardson_bars())
///
/// Both readings have the same samples. All bodies are finer: the sensor's own, other sensors, and geoms, soft or
/// rigid. In steps that were saved by a version that did not write the shapes of soft geoms, these keep their
/// tessellation.
class TessellationError {
 public:
  /// Builds the finer bodies. Throws Error if the scene does not know the bodies that are touched or a finer body
  /// cannot be built, and throws Cancelled.
  TessellationError(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress = nullptr);

  /// Returns the bar of each taxel of the sensor in a step of the scene, in the unit of the readings. The result
  /// depends on `step` only. Throws Error if a contact cannot be computed again.
  [[nodiscard]] std::vector<double> bars(const StepView& step) const;

 private:
  std::shared_ptr<const SimScene> scene_;
  std::size_t sensor_;
  SensorModelPtr finer_;
  std::vector<TouchedBody> touched_;  // finer bodies, parallel to scene_->touched[sensor_]
};

/// Measures readings that are made of samples against their integral (SamplingError), and readings that are integrals
/// against a finer tessellation (TessellationError). So a bar says how far the next better computation of the same
/// contact is.
class ErrorBars : public ErrorBarSource {
 public:
  /// Prepares the bars of each sensor. Throws Cancelled.
  explicit ErrorBars(const std::shared_ptr<const SimScene>& scene, Progress* progress = nullptr);

  [[nodiscard]] std::string missing(std::size_t sensor) const override;
  /// Throws Error for a sensor without error bars, or if a contact cannot be computed again.
  std::vector<double> measure(const StepView& step, std::size_t sensor) override;

 private:
  /// One of the measures, or the reason why there is none.
  struct OfSensor {
    std::unique_ptr<SamplingError> sampling;
    std::unique_ptr<TessellationError> tessellation;
    std::string missing;
  };
  std::vector<OfSensor> sensors_;
};

}  // namespace taxel
