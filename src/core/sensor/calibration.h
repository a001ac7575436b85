// Computes the values that a device would report from raw readings in time: a chain of stages (chain/chain.h) with its
// state. The raw readings do not change.
#pragma once

#include <span>
#include <vector>

#include "core/layout/layout.h"
#include "core/sensor/chain/chain.h"

namespace taxel {

/// Returns the values that a device reports in one contact at rest, one per taxel in layout order: without relaxation,
/// low pass, rate and latency, which need time, and with a first reading of 0 for the tare. `layout` must have a
/// calibration without errors (check_layout_values).
std::vector<double> calibrated_at_rest(const Layout& layout, std::span<const double> readings);

/// Calibrates one sensor's readings in time.
class Calibrator {
 public:
  /// `layout` must have a calibration without errors (check_layout_values). `timestep` [s] is the time between two
  /// readings, which only a latency needs. Throws Error if it is 0 and the calibration has a latency.
  explicit Calibrator(const Layout& layout, double timestep = 0);

  /// Returns the values that the device reports at `time` [s], one per taxel in layout order. Call with all readings
  /// since the start in their order. `readings` has one reading per taxel at `time`. Throws Error if the time
  /// decreases, or if the number of readings is not the number of taxels.
  const std::vector<double>& advance(double time, std::span<const double> readings);

  /// Returns to the state before the first reading, random numbers included.
  void reset();

  /// The state after the last reading. The same state and the same readings give the same bits.
  [[nodiscard]] const std::vector<double>& state() const { return state_; }
  /// Replaces the state by one of state(). Throws Error if its length or a number is not valid.
  void restore(std::span<const double> state);

 private:
  Chain chain_;
  std::vector<double> state_, values_;
};

}  // namespace taxel
