// Values of taxels over time, from a simulated run or a real sensor.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

struct TaxelSeries {
  std::string unit;                         ///< unit of the values; empty if unknown
  std::vector<double> time;                 ///< times of the rows, ascending [s]
  std::vector<int> taxel_ids;               ///< ids of the taxels; no id appears twice
  std::vector<std::vector<double>> values;  ///< for each taxel, one value per row; NaN if missing
};

/// Smallest length of a gap, in median intervals. Values are not interpolated across a gap.
inline constexpr double kGapIntervals = 5;

/// Linear interpolation of the values of one taxel.
class Interpolated {
 public:
  /// Copies the values of `series` that are not missing. `taxel` is an index in TaxelSeries::values.
  Interpolated(const TaxelSeries& series, std::size_t taxel);
  /// Returns the value at a time, linear between the previous and the next value; NaN outside the series and in a gap.
  [[nodiscard]] double at(double time) const;

 private:
  std::vector<double> time_, value_;  // times [s] and values that are not missing
  double gap_;                        // smallest length of a gap [s]
};

/// Returns the median interval between two rows [s]; 0 if there are fewer than two rows.
double median_interval(const std::vector<double>& time);

/// Returns the readings of one sensor of a recording.
TaxelSeries series_of(const Recording& recording, std::size_t sensor);

/// Returns the difference of the largest and the smallest value, without missing values; 0 if all are missing.
double range_of(const std::vector<double>& values);

}  // namespace taxel
