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

namespace {

/// What heads the columns of a sensor before their own names.
std::string prefix_of(const Recording& recording, const RecordedSensor& sensor) {
  return recording.sensors.size() > 1 ? sensor.geom + "/" : "";
}

void append_taxel_heads(std::string& text, const RecordedSensor& sensor, const std::string& prefix) {
  for (const int id : sensor.taxel_ids) text.append(",").append(csv_field(fmt::format("{}taxel_{}", prefix, id)));
}

}  // namespace

std::string recording_to_csv(const Recording& recording) {
  std::string text = "time,travel";
  for (const RecordedSensor& sensor : recording.sensors) {
    const std::string prefix = prefix_of(recording, sensor);
    for (const char* column : {"force_x", "force_y", "force_z", "area", "polygons"}) {
      text.append(",").append(csv_field(prefix + column));
    }
    append_taxel_heads(text, sensor, prefix);
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

std::string calibrated_to_csv(const Recording& recording) {
  std::string text = "time,travel";
  bool any = false;
  for (const RecordedSensor& sensor : recording.sensors) {
    if (!sensor.calibrated_unit) continue;
    append_taxel_heads(text, sensor, prefix_of(recording, sensor));
    any = true;
  }
  if (!any) return "";
  text += '\n';
  auto out = std::back_inserter(text);
  for (const RecordedRow& row : recording.rows) {
    fmt::format_to(out, "{},{}", row.time, row.travel);
    for (const SensorRecord& sensor : row.sensors)
      for (const double value : sensor.calibrated) fmt::format_to(out, ",{}", value);
    text += '\n';
  }
  return text;
}

}  // namespace taxel
