// From raw readings to what a device would report. Raw readings stay as they are; this makes a second set beside them.
//
// Order of the parts, each left out where the layout does not set it:
//   hysteresis of the skin, crosstalk between taxels, tare, gain or curve, noise, range, quantisation, sample and hold,
//   dead taxels.
// So a dead taxel still leaks into its neighbours (its skin is pressed, its wire is broken), noise is clipped and
// quantised, and a held value keeps its noise.
//
// Whatever is random is a pure function of (seed, part, taxel id, number of the value): the same bits on every machine,
// for any order of the taxels, whatever the other parts are.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/rng.h"
#include "core/layout/layout.h"

namespace taxel {

/// Calibrates one sensor's readings in time. Holds what its past leaves behind: loop positions, tares, held values.
class Calibrator {
 public:
  /// Of layout.calibration, which must be there and free of errors (check_layout_values). Cost: taxels squared where
  /// there is crosstalk.
  explicit Calibrator(const Layout& layout);

  /// The values that the device reports at `time` [s], in the order of the layout's taxels, given all readings since
  /// the start one after another. `readings` is that of each taxel at `time` and stays untouched. Throws Error when
  /// time runs backwards or the number of readings is not that of the taxels.
  const std::vector<double>& advance(double time, std::span<const double> readings);

  /// Back to the start: nothing was ever felt. The random numbers start anew as well.
  void reset();

 private:
  /// A neighbour that leaks into a taxel.
  struct Leak {
    std::size_t from = 0;
    double fraction = 0;
  };
  struct Channel {
    CounterRng noise{0};
    double tare = 0;  ///< fixed part of it [U]
    bool tare_first_reading = false;
    double gain = 1;  ///< [V/U]; behind a curve: its deviation alone
    Curve curve;
    std::optional<double> dead;
    std::vector<Leak> leaks;  ///< by ascending id
    double loop = 0;          ///< output of the play operator [U]
    double first = 0;         ///< reading at the start, behind hysteresis and crosstalk [U]
  };

  void make_leaks(const Layout& layout);
  void skin(std::span<const double> readings);
  [[nodiscard]] bool tick(double time);
  [[nodiscard]] double report(const Channel& channel, double reading) const;
  [[nodiscard]] double quantised(double value) const;

  Calibration settings_;
  std::vector<Channel> channels_;  ///< parallel to the layout's taxels
  std::vector<double> pressed_, felt_, values_;
  bool started_ = false;
  double time_ = 0;             ///< of the last reading [s]
  std::uint64_t number_ = 0;    ///< of the value that is reported: tick of the rate, without one the reading's number
  std::uint64_t readings_ = 0;  ///< taken so far
};

}  // namespace taxel
