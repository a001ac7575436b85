#include "core/project/recording/csv.h"

#include <fmt/format.h>

#include <iterator>

namespace taxel {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string recording_to_csv(const Recording& recording) {
  std::string text = "time,travel";
  for (const RecordedSensor& sensor : recording.sensors) {
    const std::string prefix = recording.sensors.size() > 1 ? sensor.geom + "/" : "";
    for (const char* column : {"force_x", "force_y", "force_z", "area", "polygons"}) {
      text.append(",").append(csv_field(prefix + column));
    }
    for (const int id : sensor.taxel_ids) {
      text.append(",").append(csv_field(fmt::format("{}taxel_{}", prefix, id)));
    }
  }
  text += '\n';
  auto out = std::back_inserter(text);
  for (const RecordedRow& row : recording.rows) {
    fmt::format_to(out, "{},{}", row.time, row.travel);
    for (const SensorRecord& sensor : row.sensors) {
      fmt::format_to(out, ",{},{},{},{},{}", sensor.force_W.x, sensor.force_W.y, sensor.force_W.z, sensor.area,
                     sensor.polygons);
      for (const double reading : sensor.readings) fmt::format_to(out, ",{}", reading);
    }
    text += '\n';
  }
  return text;
}

}  // namespace taxel
