#include "core/document/scenario/scenario.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/files.h"
#include "core/base/limits.h"
#include "core/base/text/json.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr const char* kScenarioFormat = "taxel-scenario";
constexpr std::array<std::string_view, 3> kFormatsWithScenario{kScenarioFormat, "taxel-sweep", "taxel-play"};
constexpr int kScenarioVersion = 1;

/// Lengths, and with them speeds, masses, angles and times, have the limit of coordinates, in units of the file.
void check_range(const Node& node, double value, const FieldSpec& field) {
  if (!std::isfinite(value)) node.fail(fmt::format("must be finite, is {}", value));
  if (field.range == FieldRange::positive) must_be_positive(node, value);
  if (field.range == FieldRange::not_negative) must_not_be_negative(node, value);
  const bool is_bounded = field.quantity != FieldQuantity::number && field.quantity != FieldQuantity::density;
  if (is_bounded && std::abs(value) > kFarthest)
    node.fail(fmt::format("must be at most {:g}, is {}", kFarthest, value));
}

Json to_value(const std::string& text) {
  return text;
}

Json to_value(const std::vector<WayPoint>& points) {
  Json list = Json::array();
  for (const WayPoint& point : points) {
    const dvec3& p = point.X_WM.p;
    const dquat& q = point.X_WM.q;
    list.push_back({{"time", point.time}, {"pos", {p.x, p.y, p.z}}, {"quat", {q.w, q.x, q.y, q.z}}});
  }
  return list;
}

void read_value(const Node& node, std::string& text) {
  text = node.text();
}

void read_value(const Node& node, std::vector<WayPoint>& points) {
  for (std::size_t i = 0; i < node.length(); ++i) {
    const Node point = node.item(i);
    point.only({"time", "pos", "quat"});
    const std::vector<double> q = point.at("quat").numbers(4);
    points.push_back({point.at("time").number(), {{q[0], q[1], q[2], q[3]}, point.at("pos").vector3()}});
  }
}

/// Calls v(FieldSpec, value&) for the fields that are not numbers.
template <class S, class V>
void visit_other_fields(S& scenario, const V& v) {
  visit_fields(scenario, [&](const FieldSpec& field, auto& value) {
    if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) v(field, value);
  });
}

Json to_object(Scenario scenario) {
  Json object = Json::object();
  if (!scenario.is<scenarios::Sweep>()) object["kind"] = to_word(scenario.kind());
  for (const ScenarioNumber& number : numbers_of(scenario)) object[number.field.key] = *number.value;
  if (!has_object(scenario)) return object;
  if (scenario.shape != ObjectShape::box) object["shape"] = to_word(scenario.shape);
  object["object"] = scenario.object;
  visit_other_fields(scenario, [&](const FieldSpec& field, const auto& value) { object[field.key] = to_value(value); });
  return object;
}

/// Returns the keys that the scenario uses.
std::set<std::string, std::less<>> keys_of(const Scenario& scenario) {
  std::set<std::string, std::less<>> keys{"kind"};
  if (has_object(scenario)) keys.insert({"shape", "object"});
  visit_fields(scenario, [&](const FieldSpec& field, const auto&) { keys.insert(field.key); });
  return keys;
}

/// Throws Error for a key that the scenario's kind or shape does not use.
void check_keys(const Node& node, const Scenario& scenario) {
  const auto used = keys_of(scenario), used_on_edge = keys_of(with_shape(scenario, ObjectShape::edge));
  for (const auto& item : node.json().items()) {
    const std::string& key = item.key();
    if (used.contains(key)) continue;
    if (used_on_edge.contains(key))
      node.fail_at(key, fmt::format("is used by the shape \"{}\" only", to_word(ObjectShape::edge)));
    for (const auto& word : words_of(ScenarioKind{}))
      if (keys_of(with_shape(default_scenario(word.value), ObjectShape::edge)).contains(key))
        node.fail_at(key, fmt::format("is not used by the kind \"{}\"", to_word(scenario.kind())));
    const std::vector<std::string_view> keys(used.begin(), used.end());
    node.fail_at(key, "unknown key" + meant_word(key, keys));
  }
}

Scenario scenario_values(const Node& node) {
  const auto kind = node.find("kind");
  Scenario scenario = default_scenario(kind ? kind->word<ScenarioKind>() : kKind<scenarios::Sweep>);
  scenario = with_shape(scenario, ObjectShape::box);
  if (const auto shape = node.find("shape")) scenario = with_shape(scenario, shape->word<ObjectShape>());
  check_keys(node, scenario);
  for (const ScenarioNumber& entry : numbers_of(scenario)) {
    if (const auto number = node.find(entry.field.key)) {
      *entry.value = number->number();
      check_range(*number, *entry.value, entry.field);
    }
  }
  if (const auto object = node.find("object")) scenario.object = object->text();
  visit_other_fields(scenario, [&](const FieldSpec& field, auto& value) {
    if (const auto found = node.find(field.key)) read_value(*found, value);
  });
  return scenario;
}

/// Returns the scenario object in a document.
Node scenario_of(const Node& root) {
  const auto inner = root.find("scenario");
  const auto format = root.find("format");
  if (!inner && !format) return root;
  if (!inner) root.fail_at("scenario", "is missing");
  inner->must_be_object();
  if (!format) {
    root.only({"scenario"});
    return *inner;
  }
  if (std::ranges::find(kFormatsWithScenario, format->text()) == kFormatsWithScenario.end())
    format->wrong("\"taxel-scenario\", or the format of a recording, \"taxel-sweep\" or \"taxel-play\"");
  if (format->text() == kScenarioFormat) {
    root.only({"format", "version", "scenario"});
    const double version = root.at("version").number();
    if (version != kScenarioVersion)
      root.fail_at("version", fmt::format("{} is unknown, this program reads version {}", version, kScenarioVersion));
  }
  return *inner;
}

}  // namespace

std::string scenario_to_json(const Scenario& scenario) {
  return json_line(to_object(scenario));
}

std::string scenario_file_json(const Scenario& scenario) {
  return json_text(Json{{"format", kScenarioFormat}, {"version", kScenarioVersion}, {"scenario", to_object(scenario)}});
}

Scenario parse_scenario(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  const Node node = scenario_of(root);
  const Scenario scenario = scenario_values(node);
  try {
    check_scenario(scenario);
  } catch (const Error& e) {
    throw Error(file, node.pointer() + e.where(), e.message());
  }
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& path) {
  return parse_scenario(read_file(path), path.string());
}

Scenario read_scenario_with_files(const std::filesystem::path& path) {
  return with_absolute_files(read_scenario(path), path);
}

Scenario with_absolute_files(Scenario scenario, const std::filesystem::path& file) {
  for (const auto& [key, named] : files_of(scenario))
    if (!named->empty()) *named = (std::filesystem::absolute(file).parent_path() / *named).lexically_normal().string();
  return scenario;
}

void check_scenario(const Scenario& scenario) {
  Scenario checked = scenario;
  const Json json = to_object(scenario);
  const std::string file;
  const Node node(json, file);
  for (const ScenarioNumber& number : numbers_of(checked))
    check_range(node.at(number.field.key), *number.value, number.field);
  if (scenario.shape == ObjectShape::edge && has_object(scenario) && !(scenario.edge_radius < 0.5 * scenario.box_size))
    node.fail_at("edge_radius", fmt::format("must be less than half of box_size, {}, is {}", 0.5 * scenario.box_size,
                                            scenario.edge_radius));
  if (!scenario.object.empty() && scenario.shape != ObjectShape::box)
    node.fail_at("shape", "a mesh as \"object\" takes the place of the shape: leave one of them out");
  std::visit([&](const auto& motion) { motion.check(scenario.shape); }, scenario.motion);
  for (const auto& [key, path] : files_of(checked))
    if (!is_utf8(*path))
      node.fail_at(key, "the path is not UTF-8, which a JSON file cannot hold: rename the folder or file");
}

}  // namespace taxel
