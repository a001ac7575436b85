// Error bars of the readings of all sensors of a scene.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/run/recording/run_recorder.h"
#include "core/sensor/error_bars/sampling_error.h"
#include "core/sim/compare/tessellation_error.h"

namespace taxel {

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
