// Scripts read from JSON, and expectations checked against the state of the window.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/studio/shell/script/script.h"
#include "app/studio/shell/window/input_event.h"
#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel::studio {

namespace {

using Json = nlohmann::json;

/// A whole number that an int holds. Throws Error otherwise: the JSON library would cut off what does not fit.
int whole_number(const Json& json, const std::string& key) {
  const double value = json.is_number() ? json.get<double>() : 0.5;
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
    throw Error(fmt::format("\"{}\" must be a whole number below 2^31, is {}", key, json.dump()));
  return static_cast<int>(value);
}

/// One line's object; every key asked for counts as known, and done() refuses the rest.
class Line {
 public:
  explicit Line(const Json& json) : json_(json) {}

  [[nodiscard]] bool has(const char* key) {
    read_keys_.insert(key);
    return json_.contains(key);
  }
  template <class T>
  T get(const char* key) {
    if (!has(key)) throw Error(fmt::format("needs \"{}\"", key));
    return convert<T>(key);
  }
  template <class T>
  T get(const char* key, T otherwise) {
    return has(key) ? convert<T>(key) : otherwise;
  }
  [[nodiscard]] const Json& at(const char* key) const { return json_.at(key); }
  void done() const {
    for (const auto& [key, value] : json_.items()) {
      if (!read_keys_.contains(key)) throw Error(fmt::format("does not know \"{}\"", key));
    }
  }

 private:
  template <class T>
  T convert(const char* key) {
    if constexpr (std::is_same_v<T, int>) return whole_number(json_.at(key), key);
    try {
      return json_.at(key).get<T>();
    } catch (const Json::exception&) {
      throw Error(fmt::format("\"{}\" has the wrong type: {}", key, json_.at(key).dump()));
    }
  }
  const Json& json_;
  std::set<std::string> read_keys_;
};

Target parse_target(const Json& json) {
  const auto numbers = [](const Json& list, std::size_t count) {
    bool good = list.is_array() && list.size() == count;
    for (std::size_t i = 0; good && i < count; ++i) good = list[i].is_number();
    if (!good) throw Error(fmt::format("needs {} numbers, has {}", count, list.dump()));
    return list.get<std::vector<double>>();
  };
  if (json.is_array()) {
    const auto p = numbers(json, 2);
    return PixelTarget{p[0], p[1]};
  }
  if (json.is_object() && json.size() == 1) {
    if (json.contains("world")) {
      const auto p = numbers(json["world"], 3);
      return WorldTarget{{p[0], p[1], p[2]}};
    }
    if (json.contains("view")) {
      const auto p = numbers(json["view"], 2);
      return ViewTarget{p[0], p[1]};
    }
    if (json.contains("taxel") && json["taxel"].is_number_integer())
      return TaxelTarget{whole_number(json["taxel"], "taxel")};
    if (json.contains("widget") && json["widget"].is_string()) return WidgetTarget{json["widget"].get<std::string>()};
  }
  throw Error(
      "\"at\" must be [x, y], {\"view\": [u, v]}, {\"world\": [x, y, z]}, {\"taxel\": id} or {\"widget\": "
      "\"Label\"}, is " +
      json.dump());
}

std::optional<Target> optional_target(Line& line) {
  if (!line.has("at")) return std::nullopt;
  return parse_target(line.at("at"));
}

Target target(Line& line) {
  if (!line.has("at")) throw Error("needs \"at\"");
  return parse_target(line.at("at"));
}

int button(Line& line) {
  const auto name = line.get<std::string>("button", "left");
  const std::map<std::string, int> buttons{{"left", 0}, {"right", 1}, {"middle", 2}};
  if (!buttons.contains(name)) throw Error(fmt::format("\"button\" must be left, right or middle, is \"{}\"", name));
  return buttons.at(name);
}

Modifiers modifiers(Line& line) {
  const std::map<std::string, int> modifier_keys{
      {"ctrl", ImGuiMod_Ctrl}, {"shift", ImGuiMod_Shift}, {"alt", ImGuiMod_Alt}};
  Modifiers mods;
  for (const std::string& name : line.get<std::vector<std::string>>("mods", {})) {
    if (!modifier_keys.contains(name)) throw Error(fmt::format("\"mods\" are ctrl, shift and alt, not \"{}\"", name));
    mods.push_back(static_cast<ImGuiKey>(modifier_keys.at(name)));
  }
  return mods;
}

KeyEvent key_event(Line& line, bool down, bool up) {
  const auto name = line.get<std::string>("key");
  const ImGuiKey key = key_of_name(name);
  if (key == ImGuiKey_None) throw Error(fmt::format("does not know the key \"{}\"", name));
  return {key, down, up, modifiers(line)};
}

DropEvent drop_event(Line& line, const std::filesystem::path& folder) {
  DropEvent drop;
  for (const std::string& file : line.get<std::vector<std::string>>("files"))
    drop.files.push_back((folder / file).string());
  return drop;
}

ScriptStep parse_event(const std::string& name, Line& line, const std::filesystem::path& folder) {
  if (name == "mouse_move") return MouseMoveEvent{target(line)};
  if (name == "mouse_down") return MouseButtonEvent{optional_target(line), button(line), true, modifiers(line)};
  if (name == "mouse_up") return MouseButtonEvent{optional_target(line), button(line), false, modifiers(line)};
  if (name == "click") return ClickEvent{optional_target(line), button(line), 1, modifiers(line)};
  if (name == "double_click") return ClickEvent{optional_target(line), button(line), 2, modifiers(line)};
  if (name == "wheel") {
    return WheelEvent{optional_target(line), line.get<double>("x", 0.0), line.get<double>("y", 0.0), modifiers(line)};
  }
  if (name == "key") return key_event(line, true, true);
  if (name == "key_down") return key_event(line, true, false);
  if (name == "key_up") return key_event(line, false, true);
  if (name == "text") return TextEvent{line.get<std::string>("text")};
  if (name == "drop") return drop_event(line, folder);
  if (name == "resize") return ResizeEvent{line.get<int>("width"), line.get<int>("height")};
  if (name == "close") return CloseEvent{};
  throw Error(fmt::format("does not know the event \"{}\"", name));
}

ExpectCommand parse_expect(Line& line) {
  ExpectCommand expect;
  expect.pointer = line.get<std::string>("pointer");
  if (line.has("equals")) expect.equals = line.at("equals").dump();
  expect.contains = line.get<std::string>("contains", "");
  if (line.has("least")) expect.least = line.get<double>("least");
  if (line.has("most")) expect.most = line.get<double>("most");
  if (expect.equals.empty() && expect.contains.empty() && !expect.least && !expect.most) {
    throw Error("needs one of \"equals\", \"contains\", \"least\", \"most\"");
  }
  return expect;
}

ScriptStep parse_command(const std::string& name, Line& line) {
  if (name == "screenshot") return ScreenshotCommand{line.get<std::string>("file")};
  if (name == "dump_state") return DumpStateCommand{line.get<std::string>("file")};
  if (name == "wait_idle") return WaitIdleCommand{};
  if (name == "wait_time") return WaitTimeCommand{line.get<double>("time")};
  if (name == "expect") return parse_expect(line);
  if (name == "wait_for") return WaitForCommand{parse_expect(line)};
  if (name == "rest") return RestCommand{line.get<double>("seconds")};
  if (name == "quit") return QuitCommandLine{};
  throw Error(fmt::format("does not know the command \"{}\"", name));
}

ScriptLine parse_line(const std::string& text, int number, int frame_before, const std::filesystem::path& folder) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw Error("is no JSON object");
  Line line(json);
  ScriptLine parsed;
  parsed.number = number;
  parsed.frame = line.get<int>("frame", frame_before);
  if (parsed.frame < frame_before)
    throw Error(fmt::format("frame {} comes before frame {}", parsed.frame, frame_before));
  const bool is_event = line.has("event"), is_command = line.has("do");
  if (is_event == is_command) throw Error("needs either \"event\" or \"do\"");
  parsed.step = is_event ? parse_event(line.get<std::string>("event"), line, folder)
                         : parse_command(line.get<std::string>("do"), line);
  line.done();
  return parsed;
}

}  // namespace

Script read_script(const std::filesystem::path& file) {
  return parse_script(read_file(file), file);
}

Script parse_script(const std::string& text, const std::filesystem::path& file) {
  Script script;
  script.file = file.string();
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const int frame_before = script.lines.empty() ? 0 : script.lines.back().frame;
    try {
      script.lines.push_back(parse_line(line, number, frame_before, std::filesystem::absolute(file).parent_path()));
    } catch (const Error& error) {
      throw Error(script.file, fmt::format("line {}", number), error.message());
    }
  }
  return script;
}

}  // namespace taxel::studio
