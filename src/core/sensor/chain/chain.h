// The chain of a sensor's taxels, from their readings to the values that a device reports. The readings do not change.
//
// The stages in their order, each of which the layout's calibration may leave out:
//   response of the sensing element, relaxation, hysteresis, low pass, crosstalk between taxels, tare with gain or
//   curve, noise, range, quantisation, sample and hold, latency, dead taxels.
// So a dead taxel still leaks into its neighbours, noise is clipped and quantised, and a held value includes its noise.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/sensor/chain/stage.h"

namespace taxel {

/// Immutable. Its state belongs to the caller: state_size() numbers, all of them 0 before the first reading.
class Chain {
 public:
  /// `layout` must have a calibration without errors (check_layout_values). `timestep` [s] is the time between two
  /// readings; only a latency needs it. Throws Error if it is 0 and the calibration has a latency.
  explicit Chain(const Layout& layout, double timestep = 0);

  [[nodiscard]] std::size_t taxel_count() const { return taxels_; }
  [[nodiscard]] std::size_t state_size() const { return state_size_; }

  /// Returns whether `state` is that before the first reading.
  [[nodiscard]] static bool is_new(std::span<const double> state) { return state[kReadings] == 0.0; }
  /// Returns the time of the last reading [s].
  [[nodiscard]] static double time_of(std::span<const double> state) { return state[kTime]; }

  /// Advances the state by the readings at `time` [s], one per taxel in layout order, and writes the reported values.
  /// Throws Error if the time decreases or is not finite, or if a length is not right.
  void advance(double time, std::span<const double> readings, std::span<double> state, std::span<double> values) const;

 private:
  /// The first numbers of the state: readings so far, time of the last one [s], number of the reported value.
  enum Head : std::size_t { kReadings, kTime, kValue, kHeadSize };

  [[nodiscard]] Moment moment(double time, std::span<const double> state) const;

  std::size_t taxels_ = 0, state_size_ = kHeadSize;
  std::optional<double> rate_;  ///< values per second
  std::vector<StagePtr> stages_;
};

}  // namespace taxel
