#include "app/studio/host/run/peaks.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"

namespace taxel::studio {
namespace {

/// Readings of a frame, all sensors one after the other, as trace rows have them.
std::vector<double> all_readings(const SimFrame& frame) {
  std::vector<double> all;
  for (const SensorStep& sensor : frame.sensors) all.insert(all.end(), sensor.readings.begin(), sensor.readings.end());
  return all;
}

}  // namespace

void Peaks::raise(const std::vector<double>& readings) {
  peaks_.resize(std::max(peaks_.size(), readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i) peaks_[i] = std::max(peaks_[i], readings[i]);
}

void Peaks::add(const SimFrame& frame) {
  const Trace& trace = *frame.trace;
  if (std::exchange(edition_, trace.edition) != trace.edition) {
    peaks_.clear();
    rows_ = 0;
    largest_pressure_ = 0;
  }
  for (; rows_ < trace.rows.size(); ++rows_) raise(trace.rows[rows_].readings);
  raise(all_readings(frame));
  for (const SensorStep& sensor : frame.sensors)
    for (const ContactSurface& surface : sensor.surfaces)
      largest_pressure_ = std::max(largest_pressure_, surface.max_pressure());
}

std::vector<double> Peaks::of_sensor(const SimFrame& frame, int sensor) const {
  if (sensor < 0 || at(sensor) >= frame.sensors.size()) return {};
  std::size_t first = 0;
  for (std::size_t s = 0; s < at(sensor); ++s) first += frame.sensors[s].readings.size();
  const std::size_t last = std::min(peaks_.size(), first + frame.sensors[at(sensor)].readings.size());
  return first < last
             ? std::vector<double>(peaks_.begin() + std::ptrdiff_t(first), peaks_.begin() + std::ptrdiff_t(last))
             : std::vector<double>{};
}

}  // namespace taxel::studio
