#include "core/sensor/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {

std::vector<double> calibrated_at_rest(const Layout& layout, std::span<const double> readings) {
  Layout at_rest = layout;
  Calibration& calibration = at_rest.calibration.value();
  calibration.relaxation.clear();
  calibration.low_pass.reset();
  calibration.rate.reset();
  calibration.latency = 0;
  if (calibration.tare && calibration.tare->first_reading) calibration.tare.reset();
  return Calibrator(at_rest).advance(0, readings);
}

Calibrator::Calibrator(const Layout& layout, double timestep)
    : chain_(layout, timestep), state_(chain_.state_size()), values_(chain_.taxel_count()) {}

void Calibrator::reset() {
  std::fill(state_.begin(), state_.end(), 0.0);
}

void Calibrator::restore(std::span<const double> state) {
  if (state.size() != state_.size())
    throw Error("calibration", fmt::format("a state of {} numbers, needs {}", state.size(), state_.size()));
  if (!std::all_of(state.begin(), state.end(), [](double x) { return std::isfinite(x); }))
    throw Error("calibration", "a state with a number that is not finite");
  state_.assign(state.begin(), state.end());
}

const std::vector<double>& Calibrator::advance(double time, std::span<const double> readings) {
  chain_.advance(time, readings, state_, values_);
  return values_;
}

}  // namespace taxel
