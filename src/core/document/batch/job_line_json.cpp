#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "core/base/files.h"
#include "core/base/text/json_reader.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_line.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

/// Throws Error unless a number is whole, at least `least` and at most kMaxJobs.
std::int64_t whole_count(const Node& node, int least) {
  const double value = node.number();
  if (!(value >= least && value <= static_cast<double>(kMaxJobs) && value == std::floor(value)))
    node.wrong(fmt::format("a whole number from {} to {}", least, kMaxJobs));
  return static_cast<std::int64_t>(value);
}

std::vector<std::string> range_of(const Node& node) {
  node.only({"from", "to", "count"});
  const double from = node.at("from").number(), to = node.at("to").number();
  const auto count = static_cast<std::size_t>(whole_count(node.at("count"), 2));
  std::vector<std::string> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(json_line(Json(value_of_range(from, to, i, count))));
  return values;
}

std::vector<std::string> listed_values(const Node& node, const Json& json) {
  node.only({"values"});
  const Node list = node.at("values");
  if (list.length() == 0) list.fail("must have at least one value");
  std::vector<std::string> values;
  for (const Json& value : json["values"]) values.push_back(json_line(value));
  return values;
}

Draw draw_of(const Node& node, const char* key, Distribution distribution) {
  node.only({key});
  const Node limits = node.at(key);
  const std::vector<double> two = limits.numbers(2);
  const Draw draw{distribution, two[0], two[1]};
  try {
    check_draw(draw);
  } catch (const Error& e) {
    limits.fail(e.message());
  }
  return draw;
}

/// A value is itself, unless it is an object with one of these keys.
JobParameter parameter_of(const std::string& pointer, const Node& node, const Json& json) {
  if (json.is_object()) {
    if (node.find("values")) return {pointer, listed_values(node, json)};
    if (node.find("from")) return {pointer, range_of(node)};
    if (node.find("uniform")) return {pointer, draw_of(node, "uniform", Distribution::uniform)};
    if (node.find("log_uniform")) return {pointer, draw_of(node, "log_uniform", Distribution::log_uniform)};
    if (node.find("normal")) return {pointer, draw_of(node, "normal", Distribution::normal)};
  }
  return {pointer, std::vector<std::string>{json_line(json)}};
}

/// Returns the scenario object in the text of a scenario file.
std::string inner_scenario(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  Node(json, file).must_be_object();
  return json_line(json.contains("scenario") ? json["scenario"] : json);
}

void read_scenario_of(const Node& node, const Json& json, const std::filesystem::path& folder, JobLine& line) {
  if (!node.is_text()) {
    node.must_be_object();
    line.scenario = json_line(json);
    line.scenario_file = (folder / "jobs").string();
    return;
  }
  line.scenario_file = (folder / node.text()).lexically_normal().string();
  line.scenario = inner_scenario(read_file(line.scenario_file), line.scenario_file);
}

void read_parameters(const Node& node, const Json& json, JobLine& line) {
  node.must_be_object();
  for (const auto& [pointer, value] : json.items()) {
    if (!pointer.starts_with("/layout/") && !pointer.starts_with("/scenario/"))
      node.fail_at(pointer, "must begin with /layout/ or /scenario/");
    line.parameters.push_back(parameter_of(pointer, *node.find(pointer), value));
    if (line.count() > kMaxJobs) node.fail(fmt::format("gives more than {} jobs", kMaxJobs));
  }
}

}  // namespace

std::size_t JobLine::count() const {
  std::size_t count = static_cast<std::size_t>(repeat);
  for (const JobParameter& parameter : parameters)
    if (const auto* values = std::get_if<std::vector<std::string>>(&parameter.values))
      count = std::min(count * values->size(), kMaxJobs + 1);
  return count;
}

JobLine parse_job_line(const std::string& text, const std::filesystem::path& folder) {
  const std::string file;
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.only({"layout", "scenario", "set", "repeat", "seed", "task"});
  JobLine line;
  if (const auto layout = root.find("layout")) line.layout = (folder / layout->text()).lexically_normal().string();
  read_scenario_of(root.at("scenario"), json["scenario"], folder, line);
  if (const auto set = root.find("set")) read_parameters(*set, json["set"], line);
  if (const auto repeat = root.find("repeat")) line.repeat = whole_count(*repeat, 1);
  if (const auto seed = root.find("seed")) line.seed = seed->natural();
  if (const auto task = root.find("task")) line.task = task->text();
  return line;
}

}  // namespace taxel
