#include "app/cli/recorded_sensor.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel::cli {

std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file) {
  const std::vector<RecordedSensor>& sensors = recording.sensors;
  if (sensors.empty()) throw Error(file, "sensor_geoms", "names no sensor");
  std::vector<std::size_t> with_taxels;
  std::string names;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].taxel_ids.empty()) {
      if (sensors[i].geom == geom) throw Error(file, fmt::format("geom \"{}\" is soft, but has no taxels", geom));
      continue;
    }
    if (sensors[i].geom == geom) return i;
    names += (with_taxels.empty() ? "" : ", ") + sensors[i].geom;
    with_taxels.push_back(i);
  }
  if (with_taxels.empty()) throw Error(file, "has soft geoms without taxels alone");
  if (geom.empty() && with_taxels.size() == 1) return with_taxels.front();
  throw Error(file, geom.empty() ? "has several sensors: name one by --sensor: " + names
                                 : fmt::format("has no sensor \"{}\", but {}", geom, names));
}

}  // namespace taxel::cli
