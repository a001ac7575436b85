#include "core/sim/history/breakpoints.h"

#include <algorithm>
#include <cmath>

namespace taxel {

const std::vector<std::optional<Jump>>& JumpDetector::compare(std::uint64_t step, double time,
                                                              std::span<const SensorSignal> sensors,
                                                              const Breakpoints& limits) {
  latest_.resize(sensors.size());
  jumps_.assign(sensors.size(), std::nullopt);
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const SensorSignal& now = sensors[s];
    Latest& before = latest_[s];
    for (const double reading : now.readings) before.largest = std::max(before.largest, std::abs(reading));
    const double scale = JumpDetector::scale(before.largest, now.forces, limits);
    if (begun_ && before.readings.size() == now.readings.size() && !now.readings.empty()) {
      Jump jump{.step = step, .time = time, .sensor = static_cast<int>(s)};
      double largest = -1;
      for (std::size_t k = 0; k < now.readings.size(); ++k) {
        const double change = std::abs(now.readings[k] - before.readings[k]);
        if (!(change > largest)) continue;
        largest = change;
        jump.taxel = static_cast<int>(k);
      }
      const auto k = static_cast<std::size_t>(jump.taxel);
      jump.before = before.readings[k];
      jump.after = now.readings[k];
      jump.part = scale > 0 ? largest / scale : 0.0;
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

void JumpDetector::go_on_from(std::span<const SensorSignal> sensors, std::span<const double> largest) {
  latest_.resize(sensors.size());
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    latest_[s].readings.assign(sensors[s].readings.begin(), sensors[s].readings.end());
    latest_[s].force = sensors[s].force;
    if (s < largest.size()) latest_[s].largest = largest[s];
  }
  begun_ = true;
}

}  // namespace taxel
