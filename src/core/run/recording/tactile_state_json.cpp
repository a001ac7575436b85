#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/run/recording/recording_files.h"

namespace taxel {
namespace {

constexpr std::int64_t kNanoseconds = 1'000'000'000;

std::int64_t nanoseconds(double time) {
  constexpr auto kMostSeconds = static_cast<double>(std::numeric_limits<std::uint32_t>::max());
  if (!(time >= 0) || time > kMostSeconds)
    throw Error("", "time",
                fmt::format("a stamp of ROS is from 0 to {:.0f} s, this row is of {} s", kMostSeconds, time));
  return std::llround(time * static_cast<double>(kNanoseconds));
}

}  // namespace

std::string tactile_states(const Recording& recording) {
  std::vector<std::string> names;
  for (const RecordedSensor& sensor : recording.sensors)
    names.push_back(json_line(nlohmann::ordered_json(sensor.geom)));
  std::string text;
  auto out = std::back_inserter(text);
  for (std::size_t r = 0; r < recording.rows.size(); ++r) {
    const RecordedRow& row = recording.rows[r];
    const std::int64_t stamp = nanoseconds(row.time);
    fmt::format_to(
        out, R"({{"header": {{"seq": {}, "stamp": {{"secs": {}, "nsecs": {}}}, "frame_id": "world"}}, "sensors": [)", r,
        stamp / kNanoseconds, stamp % kNanoseconds);
    for (std::size_t s = 0; s < row.sensors.size(); ++s) {
      fmt::format_to(out, R"({}{{"name": {}, "values": [)", s > 0 ? ", " : "", names[s]);
      const SensorRecord& record = row.sensors[s];
      const std::vector<double>& values = record.calibrated.empty() ? record.readings : record.calibrated;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const auto value = static_cast<float>(values[k]);
        if (!std::isfinite(value))
          throw Error(
              "", fmt::format("sensor \"{}\": taxel {}", recording.sensors[s].geom, recording.sensors[s].taxel_ids[k]),
              fmt::format("{} at {} s is no finite single", values[k], row.time));
        fmt::format_to(out, "{}{}", k > 0 ? ", " : "", value);
      }
      text += "]}";
    }
    text += "]}\n";
  }
  return text;
}

}  // namespace taxel
