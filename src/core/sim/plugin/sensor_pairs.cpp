#include "core/sim/plugin/sensor_pairs.h"

#include <algorithm>

#include "core/base/error.h"

namespace taxel {
namespace {

/// The sensor that stands for a geom; null where none lies on it.
const DeclaredSensor* sensor_on(const std::vector<DeclaredSensor>& sensors, int geom) {
  const DeclaredSensor* found = nullptr;
  for (const DeclaredSensor& s : sensors) {
    if (s.config.geom != geom) continue;
    if (found == nullptr || (s.config.apply && !found->config.apply)) found = &s;
  }
  return found;
}

/// By name, so that neither the order of the sensors nor that of the bodies changes a bit of the result.
bool computes_before(const SensorConfig& a, const SensorConfig& b) {
  return a.apply != b.apply ? a.apply : a.geom_name < b.geom_name;
}

}  // namespace

std::vector<DeclaredSensor> declared_sensors(const mjModel& m, int instance) {
  std::vector<DeclaredSensor> sensors;
  for (int i = 0; i < m.nplugin; ++i) {
    if (m.plugin[i] != m.plugin[instance]) continue;
    try {
      sensors.push_back({i, read_sensor_config(m, i)});
    } catch (const Error&) {
      if (i == instance) throw;
    }
  }
  return sensors;
}

void add_sensors_that_touch(const std::vector<DeclaredSensor>& sensors, SensorConfig& config) {
  for (const DeclaredSensor& s : sensors) {
    const std::vector<int>& theirs = s.config.others;
    const auto place = std::lower_bound(config.others.begin(), config.others.end(), s.config.geom);
    if (!std::binary_search(theirs.begin(), theirs.end(), config.geom)) continue;
    if (place == config.others.end() || *place != s.config.geom) config.others.insert(place, s.config.geom);
  }
}

PairRole pair_role(const std::vector<DeclaredSensor>& sensors, int self, const SensorConfig& config, int geom) {
  const DeclaredSensor* other = sensor_on(sensors, geom);
  if (other == nullptr) return {-1, false, config.apply};
  if (sensor_on(sensors, config.geom)->instance != self) return {other->instance, false, false};
  return {other->instance, computes_before(other->config, config), config.apply || other->config.apply};
}

}  // namespace taxel
