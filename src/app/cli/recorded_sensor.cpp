#include "app/cli/recorded_sensor.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel::cli {

std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file) {
  const std::vector<RecordedSensor>& sensors = recording.sensors;
  std::string names;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].geom == geom) return i;
    names += (i > 0 ? ", " : "") + sensors[i].geom;
  }
  if (geom.empty() && sensors.size() == 1) return 0;
  if (sensors.empty()) throw Error(file, "sensor_geoms", "names no sensor");
  throw Error(file, geom.empty() ? "has several sensors: name one by --sensor: " + names
                                 : fmt::format("has no sensor \"{}\", but {}", geom, names));
}

}  // namespace taxel::cli
