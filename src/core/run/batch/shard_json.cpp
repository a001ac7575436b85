#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/text/json.h"
#include "core/run/batch/shard.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr int kShardVersion = 2;
constexpr std::uint64_t kMostCount = std::numeric_limits<std::int32_t>::max();

/// Returns a number of rows or of values in a row. Products and sums of such numbers must not overflow.
std::uint64_t count_at(const Node& node, const char* key) {
  const std::uint64_t count = node.at(key).natural();
  if (count > kMostCount) node.fail_at(key, fmt::format("must be at most {}", kMostCount));
  return count;
}

JobOutcome read_outcome(const Node& node) {
  JobOutcome outcome;
  outcome.id = node.at("id").text();
  if (const auto error = node.find("error")) {
    outcome.error = error->text();
    if (outcome.error.empty()) error->fail("must not be empty");
    return outcome;
  }
  outcome.rows = static_cast<std::int64_t>(count_at(node, "rows"));
  outcome.summary = {node.at("largest_force").number(), node.at("peak").number(), node.at("peak_taxel").small_integer(),
                     node.at("duration").number()};
  return outcome;
}

EpisodeSensor read_sensor(const Node& node) {
  EpisodeSensor sensor;
  sensor.layout_key = node.at("layout_key").text();
  sensor.layout_json = node.at("layout").text();
  sensor.layout_name = node.at("name").text();
  sensor.unit = node.at("unit").text();
  sensor.calibrated_unit = node.at("calibrated_unit").text();
  const Node ids = node.at("taxel_ids"), names = node.at("taxel_names");
  for (std::size_t i = 0; i < ids.length(); ++i) sensor.taxel_ids.push_back(ids.item(i).small_integer());
  for (std::size_t i = 0; i < names.length(); ++i) sensor.taxel_names.push_back(names.item(i).text());
  if (names.length() != ids.length()) names.fail("must have as many texts as taxel_ids");
  return sensor;
}

}  // namespace

std::string shard_head_to_json(const ShardHead& head) {
  Json outcomes = Json::array();
  for (const JobOutcome& outcome : head.outcomes) {
    Json& one = outcomes.emplace_back(Json{{"id", outcome.id}});
    if (!outcome.error.empty()) {
      one["error"] = outcome.error;
      continue;
    }
    one["rows"] = outcome.rows;
    one["largest_force"] = outcome.summary.largest_force;
    one["peak"] = outcome.summary.peak;
    one["peak_taxel"] = outcome.summary.peak_taxel;
    one["duration"] = outcome.summary.duration;
  }
  Json json{{"version", kShardVersion}, {"group", head.group}, {"jobs", outcomes}};
  Json& columns = json["columns"] = Json::array();
  for (const ShardColumn& column : head.columns)
    columns.push_back(Json{{"name", column.name}, {"width", column.width}, {"is_list", column.is_list}});
  if (head.sensor)
    json["sensor"] = {{"layout_key", head.sensor->layout_key},
                      {"layout", head.sensor->layout_json},
                      {"name", head.sensor->layout_name},
                      {"unit", head.sensor->unit},
                      {"calibrated_unit", head.sensor->calibrated_unit},
                      {"taxel_ids", head.sensor->taxel_ids},
                      {"taxel_names", head.sensor->taxel_names}};
  return json_line(json);
}

ShardHead parse_shard_head(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (root.at("version").number() != kShardVersion)
    root.fail_at("version", fmt::format("must be {}, is {}", kShardVersion, root.at("version").number()));
  ShardHead head;
  head.group = root.at("group").text();
  const Node jobs = root.at("jobs");
  for (std::size_t i = 0; i < jobs.length(); ++i) head.outcomes.push_back(read_outcome(jobs.item(i)));
  const Node columns = root.at("columns");
  for (std::size_t i = 0; i < columns.length(); ++i) {
    const Node one = columns.item(i);
    head.columns.push_back({one.at("name").text(), count_at(one, "width"), one.at("is_list").flag()});
    if (!one.at("is_list").flag() && head.columns.back().width != 1) one.fail_at("width", "must be 1 without a list");
  }
  if (const auto sensor = root.find("sensor")) head.sensor = read_sensor(*sensor);
  return head;
}

}  // namespace taxel
