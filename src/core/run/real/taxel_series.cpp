#include "core/run/real/taxel_series.h"

#include <algorithm>
#include <cmath>

namespace taxel {

double median_interval(const std::vector<double>& time) {
  if (time.size() < 2) return 0;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time.size(); ++i) intervals.push_back(time[i] - time[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

Interpolated::Interpolated(const TaxelSeries& series, std::size_t taxel)
    : gap_(kGapIntervals * median_interval(series.time)) {
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (std::isnan(series.values[taxel][i])) continue;
    time_.push_back(series.time[i]);
    value_.push_back(series.values[taxel][i]);
  }
}

double Interpolated::at(double time) const {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  if (time_.empty() || time < time_.front() || time > time_.back()) return kNothing;
  const auto next = static_cast<std::size_t>(std::lower_bound(time_.begin(), time_.end(), time) - time_.begin());
  if (time_[next] == time) return value_[next];
  const double width = time_[next] - time_[next - 1];
  if (width > gap_) return kNothing;
  const double part = (time - time_[next - 1]) / width;
  return (1 - part) * value_[next - 1] + part * value_[next];
}

TaxelSeries series_of(const Recording& recording, std::size_t sensor) {
  const RecordedSensor& of = recording.sensors[sensor];
  TaxelSeries series{of.reading_unit, {}, of.taxel_ids, {}};
  series.values.resize(of.taxel_ids.size());
  for (const RecordedRow& row : recording.rows) {
    if (!series.time.empty() && row.time <= series.time.back()) continue;
    series.time.push_back(row.time);
    for (std::size_t k = 0; k < series.values.size(); ++k) series.values[k].push_back(row.sensors[sensor].readings[k]);
  }
  return series;
}

double range_of(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const double value : values)
    if (!std::isnan(value)) least = std::min(least, value), largest = std::max(largest, value);
  return largest >= least ? largest - least : 0;
}

}  // namespace taxel
