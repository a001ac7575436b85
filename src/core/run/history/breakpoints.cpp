#include "core/run/history/breakpoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taxel {
namespace {

void add_to_history(std::span<const double> readings, ReadingHistory& history) {
  if (history.largest.size() != readings.size()) {
    history.largest.assign(readings.size(), 0.0);
    history.touched.assign(readings.size(), 0);
  }
  for (std::size_t k = 0; k < readings.size(); ++k) {
    history.largest[k] = std::max(history.largest[k], std::abs(readings[k]));
    history.touched[k] += readings[k] != 0 ? 1 : 0;
  }
}

template <class T>
T largest_of(const std::vector<T>& values) {
  return values.empty() ? T{} : *std::max_element(values.begin(), values.end());
}

}  // namespace

double JumpDetector::largest(std::size_t sensor) const {
  return largest_of(latest_[sensor].history.largest);
}

double JumpDetector::scale(std::size_t sensor, int taxel, double least, bool of_sensor) const {
  const ReadingHistory& history = latest_[sensor].history;
  if (static_cast<std::size_t>(taxel) >= history.largest.size()) return std::numeric_limits<double>::infinity();
  return std::max(of_sensor ? largest_of(history.largest) : history.largest[static_cast<std::size_t>(taxel)], least);
}

double JumpDetector::counted_scale(const ReadingHistory& history, std::size_t taxel, double least, double limit,
                                   bool of_sensor) {
  const int touched = of_sensor ? largest_of(history.touched) : history.touched[taxel];
  if (touched * limit < kMaxGrowth) return std::numeric_limits<double>::infinity();
  return std::max(of_sensor ? largest_of(history.largest) : history.largest[taxel], least);
}

std::vector<double> JumpDetector::scales(std::size_t sensor, double least, double limit, bool of_sensor) const {
  const ReadingHistory& history = latest_[sensor].history;
  std::vector<double> all(history.largest.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = counted_scale(history, k, least, limit, of_sensor);
  return all;
}

const std::vector<std::optional<Jump>>& JumpDetector::compare(std::uint64_t step, double time,
                                                              std::span<const SensorSignal> sensors,
                                                              const Breakpoints& limits) {
  latest_.resize(sensors.size());
  jumps_.assign(sensors.size(), std::nullopt);
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const SensorSignal& now = sensors[s];
    Latest& before = latest_[s];
    add_to_history(now.readings, before.history);
    if (begun_ && before.readings.size() == now.readings.size() && !now.readings.empty()) {
      const double of_sensor = limits.of_sensor ? counted_scale(before.history, 0, now.least, limits.jump, true) : 0.0;
      Jump jump{.step = step, .time = time, .sensor = static_cast<int>(s)};
      double largest = -1;
      for (std::size_t k = 0; k < now.readings.size(); ++k) {
        const double change = std::abs(now.readings[k] - before.readings[k]);
        jump.largest_change = std::max(jump.largest_change, change);
        const double whole =
            limits.of_sensor ? of_sensor : counted_scale(before.history, k, now.least, limits.jump, false);
        const double part = whole > 0 ? change / whole : 0.0;
        if (part < jump.part || (part == jump.part && !(change > largest))) continue;
        largest = change;
        jump.part = part;
        jump.taxel = static_cast<int>(k);
      }
      const auto k = static_cast<std::size_t>(jump.taxel);
      jump.before = before.readings[k];
      jump.after = now.readings[k];
      jump.force_before = before.force;
      jump.force_after = now.force;
      jump.at_equal_force =
          std::abs(now.force - before.force) <= limits.equal_force * std::max(now.force, before.force);
      jumps_[s] = jump;
    }
    before.readings.assign(now.readings.begin(), now.readings.end());
    before.force = now.force;
  }
  begun_ = true;
  return jumps_;
}

void JumpDetector::continue_from(std::span<const SensorSignal> sensors, std::span<const ReadingHistory> histories) {
  latest_.resize(sensors.size());
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    latest_[s].readings.assign(sensors[s].readings.begin(), sensors[s].readings.end());
    latest_[s].force = sensors[s].force;
    if (s < histories.size()) latest_[s].history = histories[s];
  }
  begun_ = true;
}

}  // namespace taxel
