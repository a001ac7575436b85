// tactile_msgs/TactileState as JSON, as `--tactile-state` writes it. The message has a name and values for each sensor,
// but neither positions nor normals, so no layout can be made of it, nor a message of a layout, which has no readings.
// The row exists for its message: such a file is taken for a layout by its name.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/layout/formats/layout_format.h"

namespace taxel {
namespace {

using StateJson = nlohmann::ordered_json;
using StateValue = JsonNode<StateJson>;
using StateObject = JsonObject<StateJson>;

constexpr std::size_t kShownSensors = 10;

/// Throws Error naming the sensors of the first message and what gives their positions.
std::vector<ImportedLayout> refuse_tactile_state(const std::string& text, const std::string& file) {
  const std::string line = text.substr(0, text.find('\n'));
  const StateJson json = parse_json<StateJson>(line.find('}') == std::string::npos ? text : line, file);
  UnknownJson unknown;
  const StateValue root(json, file, &unknown);
  StateObject message(root);
  std::string sensors;
  const StateValue list = message.required("sensors");
  const std::size_t count = list.length();
  for (std::size_t i = 0; i < count; ++i) {
    const StateValue item = list.item(i);
    StateObject sensor(item);
    const std::string name = sensor.required("name").text();
    const std::size_t values = sensor.required("values").length();
    sensor.keep_unknown();
    if (i < kShownSensors)
      sensors += fmt::format("{}\"{}\" ({} values)", i > 0 ? ", " : "", name.substr(0, 60), values);
  }
  message.keep_unknown();
  if (count > kShownSensors) sensors += fmt::format(" and {} more", count - kShownSensors);
  throw Error(file, "/sensors",
              fmt::format("holds readings of {} but no positions of taxels, so it is no layout: take the sensor's own "
                          "description (URDF, YAML, a table or a layout), whose taxels are in the order of the values",
                          sensors.empty() ? "no sensor" : sensors));
}

bool is_tactile_state(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' && bytes.find("\"stamp\"") != std::string_view::npos &&
         bytes.find("\"sensors\"") != std::string_view::npos && bytes.find("\"values\"") != std::string_view::npos;
}

}  // namespace

LayoutFormat tactile_state_format() {
  LayoutFormat format{"tactile_state", "Message TactileState of ROS", {".jsonl", ".json"}};
  format.reads_several = format.is_refused = true;
  format.is_start = is_tactile_state;
  format.parse = refuse_tactile_state;
  return format;
}

}  // namespace taxel
