#include "core/document/scenario/scenario_json.h"

#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json_reader.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr const char* kFormat = "taxel-scenario";
constexpr int kVersion = 1;
/// How far from 1 the length of a way point's quaternion may be: what rounding and typing leave.
constexpr double kUnitTolerance = 1e-6;

void check_range(const Node& node, double value, ParameterRange range) {
  if (!std::isfinite(value)) node.fail(fmt::format("must be finite, is {}", value));
  if (range == ParameterRange::positive) node.must_be_positive(value);
  if (range == ParameterRange::not_negative) node.must_not_be_negative(value);
}

Json to_object(const WayPoint& point) {
  const dvec3& p = point.X_WM.p;
  const dquat& q = point.X_WM.q;
  return {{"time", point.time}, {"pos", {p.x, p.y, p.z}}, {"quat", {q.w, q.x, q.y, q.z}}};
}

Json to_object(const Scenario& scenario) {
  Json object = Json::object();
  if (scenario.kind != ScenarioKind::sweep) object["kind"] = to_word(scenario.kind);
  for (const ScenarioParameter& parameter : scenario_parameters())
    if (parameter.used_by(scenario)) object[parameter.key] = scenario.*parameter.value;
  if (scenario.kind == ScenarioKind::paper) return object;  // its object is given
  if (scenario.shape != ObjectShape::box) object["shape"] = to_word(scenario.shape);
  object["object"] = scenario.object;
  if (scenario.kind == ScenarioKind::replay) object["source"] = scenario.source;
  if (scenario.kind == ScenarioKind::path) {
    object["points"] = Json::array();
    for (const WayPoint& point : scenario.points) object["points"].push_back(to_object(point));
  }
  return object;
}

/// Every key belongs to the scenario's kind and shape.
void check_keys(const Node& node, const Json& json, const Scenario& scenario) {
  const ScenarioKind kind = scenario.kind;
  for (const auto& item : json.items()) {
    const std::string& key = item.key();
    const bool of_object = key == "shape" || key == "object";
    bool known = key == "kind" || of_object, used = key == "kind" || (of_object && kind != ScenarioKind::paper);
    for (const ScenarioParameter& parameter : scenario_parameters()) {
      known = known || key == parameter.key;
      if (key != parameter.key) continue;
      used = parameter.used_by(scenario);
      if (!used && parameter.used_by(kind, ObjectShape::edge))
        node.fail_at(key, fmt::format("is used by the shape \"{}\" only", to_word(ObjectShape::edge)));
    }
    known = known || key == "source" || key == "points";
    used = used || (key == "source" && kind == ScenarioKind::replay) || (key == "points" && kind == ScenarioKind::path);
    if (!known) node.fail_at(key, "unknown key");
    if (!used) node.fail_at(key, fmt::format("is not used by the kind \"{}\"", to_word(kind)));
  }
}

WayPoint read_point(const Node& node) {
  node.only({"time", "pos", "quat"});
  const std::vector<double> q = node.at("quat").numbers(4);
  return {node.at("time").number(), {{q[0], q[1], q[2], q[3]}, node.at("pos").vector3()}};
}

Scenario read_values(const Node& node, const Json& json) {
  const auto kind = node.find("kind");
  Scenario scenario = default_scenario(kind ? kind->word<ScenarioKind>() : ScenarioKind::sweep);
  scenario = with_shape(scenario, ObjectShape::box);
  if (const auto shape = node.find("shape")) scenario = with_shape(scenario, shape->word<ObjectShape>());
  check_keys(node, json, scenario);
  for (const ScenarioParameter& parameter : scenario_parameters()) {
    if (const auto number = node.find(parameter.key)) {
      scenario.*parameter.value = number->number();
      check_range(*number, scenario.*parameter.value, parameter.range);
    }
  }
  if (const auto object = node.find("object")) scenario.object = object->text();
  if (const auto source = node.find("source")) scenario.source = source->text();
  if (const auto points = node.find("points"))
    for (std::size_t i = 0; i < points->length(); ++i) scenario.points.push_back(read_point(points->item(i)));
  return scenario;
}

void check_points(const std::vector<WayPoint>& points) {
  if (points.size() < 2) throw Error("", "/points", fmt::format("a path needs 2 way points, has {}", points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string at = fmt::format("/points/{}", i);
    const WayPoint& point = points[i];
    if (!std::isfinite(point.time) || point.time < 0)
      throw Error("", at + "/time", fmt::format("must not be negative, is {}", point.time));
    if (i > 0 && !(point.time > points[i - 1].time))
      throw Error(
          "", at + "/time",
          fmt::format("must be later than that of the way point before, {}, is {}", points[i - 1].time, point.time));
    if (!is_finite(point.X_WM.p)) throw Error("", at + "/pos", "must be finite");
    const double length = glm::length(point.X_WM.q);
    if (!(std::abs(length - 1) <= kUnitTolerance))
      throw Error("", at + "/quat", fmt::format("must be of length 1, is of length {}", length));
  }
}

/// The scenario's own object in a document.
Node scenario_of(const Node& root) {
  const auto inner = root.find("scenario");
  const auto format = root.find("format");
  if (!inner && !format) return root;
  if (!inner) root.fail_at("scenario", "is missing");
  inner->must_be_object();
  if (format && format->text() == kFormat) {
    root.only({"format", "version", "scenario"});
    const double version = root.at("version").number();
    if (version != kVersion)
      root.fail_at("version", fmt::format("{} is unknown, this program reads version {}", version, kVersion));
  }
  return *inner;
}

}  // namespace

std::string scenario_to_json(const Scenario& scenario) {
  return json_line(to_object(scenario));
}

std::string scenario_file_json(const Scenario& scenario) {
  return json_text(Json{{"format", kFormat}, {"version", kVersion}, {"scenario", to_object(scenario)}});
}

Scenario parse_scenario(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  const Node node = scenario_of(root);
  const Scenario scenario = read_values(node, node.pointer().empty() ? json : json["scenario"]);
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
  for (std::string* named : {&scenario.object, &scenario.source})
    if (!named->empty()) *named = (std::filesystem::absolute(file).parent_path() / *named).lexically_normal().string();
  return scenario;
}

void check_scenario(const Scenario& scenario) {
  const Json json = to_object(scenario);
  const std::string file;
  const Node node(json, file);
  for (const ScenarioParameter& parameter : scenario_parameters())
    if (parameter.used_by(scenario)) check_range(node.at(parameter.key), scenario.*parameter.value, parameter.range);
  if (scenario.kind == ScenarioKind::sweep && scenario.shape != ObjectShape::edge &&
      !(scenario.before + scenario.past > 0))
    node.fail_at("past", "before and past together must be greater than 0");
  if (scenario.shape == ObjectShape::edge && scenario.kind != ScenarioKind::paper &&
      !(scenario.edge_radius < 0.5 * scenario.box_size))
    node.fail_at("edge_radius", fmt::format("must be less than half of box_size, {}, is {}", 0.5 * scenario.box_size,
                                            scenario.edge_radius));
  if (!scenario.object.empty() && scenario.shape != ObjectShape::box)
    node.fail_at("shape", "a mesh as \"object\" takes the place of the shape: leave one of them out");
  if (scenario.kind == ScenarioKind::replay && scenario.source.empty())
    node.fail_at("source", "a replay needs a recording: a folder or its .npz");
  if (scenario.kind == ScenarioKind::path) check_points(scenario.points);
  for (const auto& [key, path] : {std::pair("object", &scenario.object), std::pair("source", &scenario.source)})
    if (!is_utf8(*path))
      node.fail_at(key, "the path is not UTF-8, which a JSON file cannot hold: rename the folder or file");
}

}  // namespace taxel
