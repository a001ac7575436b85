// Computes the values that a device would report from raw readings. The raw readings do not change.
//
// The parts in their order, each of which the layout may leave out:
//   hysteresis of the skin, crosstalk between taxels, tare, gain or curve, noise, range, quantisation, sample and hold,
//   dead taxels.
// So a dead taxel still leaks into its neighbours (its skin is pressed, only its wire is broken), noise is clipped and
// quantised, and a held value includes its noise.
//
// A random number is a function of (seed, part, taxel id, number of the value) alone: it has the same bits on every
// machine, for any order of the taxels, and with any other parts.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/rng.h"
#include "core/layout/layout.h"

namespace taxel {

/// Calibrates one sensor's readings in time. Its state has loop positions, tares and held values.
class Calibrator {
 public:
  /// `layout` must have a calibration without errors (check_layout_values). With crosstalk the cost is quadratic in the
  /// number of taxels.
  explicit Calibrator(const Layout& layout);

  /// Returns the values that the device reports at `time` [s], one per taxel in layout order. Call with all readings
  /// since the start in their order. `readings` has one reading per taxel at `time`. Throws Error if the time
  /// decreases, or if the number of readings is not the number of taxels.
  const std::vector<double>& advance(double time, std::span<const double> readings);

  /// Returns to the state before the first reading, random numbers included.
  void reset();

 private:
  /// A neighbour that leaks into a taxel.
  struct Leak {
    std::size_t from = 0;
    double fraction = 0;
  };
  /// The parameters and the state of one taxel.
  struct Channel {
    CounterRng noise{0};
    double tare = 0;  ///< fixed tare [U]
    bool tare_first_reading = false;
    double gain = 1;  ///< gain [V/U]; after a curve only the deviation of the gain
    Curve curve;
    std::optional<double> dead;
    std::vector<Leak> leaks;  ///< neighbours by ascending id
    double loop = 0;          ///< output of the play operator [U]
    double first = 0;         ///< first reading after hysteresis and crosstalk [U]
  };

  void make_leaks(const Layout& layout);
  void skin(std::span<const double> readings);
  [[nodiscard]] bool tick(double time);
  [[nodiscard]] double report(const Channel& channel, double reading) const;
  [[nodiscard]] double quantised(double value) const;

  Calibration settings_;
  std::vector<Channel> channels_;  ///< one per taxel of the layout
  std::vector<double> pressed_, felt_, values_;
  bool started_ = false;
  double time_ = 0;             ///< time of the last reading [s]
  std::uint64_t number_ = 0;    ///< number of the reported value: a tick, or without a rate a reading
  std::uint64_t readings_ = 0;  ///< number of readings so far
};

}  // namespace taxel
