// Values of taxels over time, from wherever: a run, or a real sensor.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

struct TaxelSeries {
  std::string unit;                         ///< of the values; empty: unknown
  std::vector<double> time;                 ///< ascending [s]
  std::vector<int> taxel_ids;               ///< each once
  std::vector<std::vector<double>> values;  ///< per taxel, parallel to time; NaN: missing
};

/// Between rows that are farther apart than so many of the median interval nothing is interpolated: it is a gap.
inline constexpr double kGapIntervals = 5;

/// What one taxel of a series is at any time.
class Interpolated {
 public:
  /// Borrows the series.
  Interpolated(const TaxelSeries& series, std::size_t taxel);
  /// Linear between the values before and after that are there; NaN outside of them and in a gap.
  [[nodiscard]] double at(double time) const;

 private:
  std::vector<double> time_, value_;  // of the values that are there
  double gap_;                        // [s]
};

/// Of the rows' own distances; 0 where there are fewer than two.
double median_interval(const std::vector<double>& time);

/// The readings of one sensor of a recording.
TaxelSeries series_of(const Recording& recording, std::size_t sensor);

/// Largest less smallest value that is there; 0 where none is.
double range_of(const std::vector<double>& values);

}  // namespace taxel
