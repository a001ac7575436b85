#include "core/run/recording/recording_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/base/text/table.h"

namespace taxel {

namespace {

/// Returns the prefix of the column names of a sensor.
std::string prefix_of(const Recording& recording, const RecordedSensor& sensor) {
  return recording.sensors.size() > 1 ? sensor.geom + "/" : "";
}

void append_taxel_heads(std::string& text, const RecordedSensor& sensor, const std::string& prefix,
                        std::initializer_list<const char*> parts = {""}) {
  for (const int id : sensor.taxel_ids)
    for (const char* part : parts) text.append(",").append(csv_field(fmt::format("{}taxel_{}{}", prefix, id, part)));
}

/// Returns a table with time, travel and the columns of each sensor that has such values; empty if no sensor has any.
template <class Has, class AppendHeads, class AppendValues>
std::string table_of(const Recording& recording, const Has& has, const AppendHeads& heads, const AppendValues& values) {
  if (std::none_of(recording.sensors.begin(), recording.sensors.end(), has)) return "";
  std::string text = "time,travel";
  for (const RecordedSensor& sensor : recording.sensors)
    if (has(sensor)) heads(text, sensor, prefix_of(recording, sensor));
  text += '\n';
  auto out = std::back_inserter(text);
  for (const RecordedRow& row : recording.rows) {
    fmt::format_to(out, "{},{}", row.time, row.travel);
    for (const SensorRecord& sensor : row.sensors) values(out, sensor);
    text += '\n';
  }
  return text;
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
    if (sensor.errors) append_taxel_heads(text, sensor, prefix, {"_error"});
  }
  text += '\n';
  auto out = std::back_inserter(text);
  for (const RecordedRow& row : recording.rows) {
    fmt::format_to(out, "{},{}", row.time, row.travel);
    for (const SensorRecord& sensor : row.sensors) {
      fmt::format_to(out, ",{},{},{},{},{}", sensor.force_W.x, sensor.force_W.y, sensor.force_W.z, sensor.area,
                     sensor.polygons);
      for (const double reading : sensor.readings) fmt::format_to(out, ",{}", reading);
      for (const double error : sensor.errors) fmt::format_to(out, ",{}", error);
    }
    text += '\n';
  }
  return text;
}

std::string calibrated_to_csv(const Recording& recording) {
  return table_of(
      recording, [](const RecordedSensor& sensor) { return sensor.calibrated_unit.has_value(); },
      [](std::string& text, const RecordedSensor& sensor, const std::string& prefix) {
        append_taxel_heads(text, sensor, prefix);
      },
      [](auto& out, const SensorRecord& sensor) {
        for (const double value : sensor.calibrated) fmt::format_to(out, ",{}", value);
      });
}

std::string slip_to_csv(const Recording& recording) {
  return table_of(
      recording, [](const RecordedSensor& sensor) { return sensor.slip; },
      [](std::string& text, const RecordedSensor& sensor, const std::string& prefix) {
        append_taxel_heads(text, sensor, prefix);
      },
      [](auto& out, const SensorRecord& sensor) {
        for (const double value : sensor.slip) fmt::format_to(out, ",{}", value);
      });
}

std::string shear_to_csv(const Recording& recording) {
  return table_of(
      recording, [](const RecordedSensor& sensor) { return sensor.shear; },
      [](std::string& text, const RecordedSensor& sensor, const std::string& prefix) {
        append_taxel_heads(text, sensor, prefix, {"_e1", "_e2"});
      },
      [](auto& out, const SensorRecord& sensor) {
        for (const dvec2& value : sensor.shear) fmt::format_to(out, ",{},{}", value.x, value.y);
      });
}

}  // namespace taxel
