// Latency: values are reported a fixed number of steps later, the latency to the nearest step. Until the first value
// has arrived it is reported as the earliest one that exists.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/sensor/chain/stage.h"

namespace taxel {
namespace {

/// The state is a ring of the values of the last `steps` readings: reading n has slot n mod steps.
class LatencyStage : public Stage {
 public:
  LatencyStage(std::size_t steps, std::size_t taxels) : steps_(steps), taxels_(taxels) {}

  [[nodiscard]] std::size_t state_size() const override { return steps_ * taxels_; }

  void apply(const Moment& now, std::span<double> state, std::span<double> values) const override {
    const std::size_t own = now.reading % steps_;
    if (now.reading < steps_) {
      const std::span<double> first = state.first(taxels_);
      for (std::size_t k = 0; k < taxels_; ++k) state[own * taxels_ + k] = values[k];
      for (std::size_t k = 0; k < taxels_; ++k) values[k] = first[k];
      return;
    }
    // The slot has the values of reading n - steps.
    for (std::size_t k = 0; k < taxels_; ++k) std::swap(state[own * taxels_ + k], values[k]);
  }

 private:
  std::size_t steps_, taxels_;
};

}  // namespace

StagePtr make_latency(const ChainSettings& settings) {
  const double latency = settings.calibration.latency;
  if (!(latency > 0.0)) return nullptr;
  if (!(settings.timestep > 0.0))
    throw Error("calibration", fmt::format("a latency of {} s needs the time between two readings", latency));
  const double steps = std::round(latency / settings.timestep);
  if (steps < 1.0) return nullptr;    // less than half a step
  constexpr double kMostSteps = 1e4;  // each step is a number of the state for each taxel
  if (steps > kMostSteps)
    throw Error("calibration", fmt::format("a latency of {} s is {} steps of {} s, and {} are the most", latency, steps,
                                           settings.timestep, kMostSteps));
  return std::make_shared<LatencyStage>(static_cast<std::size_t>(steps), settings.taxel_count());
}

}  // namespace taxel
