// The largest values of a run so far.
#pragma once

#include <cstdint>
#include <vector>

#include "core/run/frame.h"

namespace taxel::studio {

/// The largest reading of each taxel and the largest pressure of a run.
class Peaks {
 public:
  /// Adds the readings of a step and of the rows before it. Another edition of the trace starts again.
  void add(const SimFrame& frame);
  /// Returns the largest pressure of all sensors [Pa].
  [[nodiscard]] double largest_pressure() const { return largest_pressure_; }
  /// Returns the largest readings of all sensors, one sensor after the other [Pa].
  [[nodiscard]] const std::vector<double>& all() const { return peaks_; }
  /// Returns the largest readings of one sensor, one per taxel [Pa]; empty if the frame has no such sensor.
  [[nodiscard]] std::vector<double> of_sensor(const SimFrame& frame, int sensor) const;

 private:
  void raise(const std::vector<double>& readings);

  std::vector<double> peaks_;  // of all sensors, one after the other [Pa]
  double largest_pressure_ = 0;
  std::size_t rows_ = 0;       // number of added rows of the trace
  std::uint64_t edition_ = 0;  // Trace::edition of the peaks
};

}  // namespace taxel::studio
