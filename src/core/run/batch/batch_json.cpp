// The texts of a batch, written and read: the description of a shard, and the index.
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/run/batch/batch_index.h"
#include "core/run/batch/shard.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

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

EpisodeSummary read_summary(const Node& node) {
  EpisodeSummary summary{node.at("largest_force").number(), node.at("peak").number(),
                         node.at("peak_taxel").small_integer(), node.at("duration").number()};
  if (const auto sensor = node.find("peak_sensor")) summary.peak_sensor = sensor->text();
  return summary;
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
  outcome.summary = read_summary(node);
  return outcome;
}

Json sensor_json(const EpisodeSensor& sensor) {
  return {{"key", sensor.layout_key},      {"name", sensor.layout_name},
          {"unit", sensor.unit},           {"calibrated_unit", sensor.calibrated_unit},
          {"taxel_ids", sensor.taxel_ids}, {"taxel_names", sensor.taxel_names},
          {"layout", sensor.layout_json}};
}

EpisodeSensor read_sensor(const Node& node) {
  EpisodeSensor sensor;
  sensor.layout_key = node.at("key").text();
  sensor.layout_name = node.at("name").text();
  sensor.unit = node.at("unit").text();
  sensor.calibrated_unit = node.at("calibrated_unit").text();
  sensor.layout_json = node.at("layout").text();
  const Node ids = node.at("taxel_ids"), names = node.at("taxel_names");
  if (names.length() != ids.length()) names.fail("must have as many texts as taxel_ids");
  for (std::size_t i = 0; i < ids.length(); ++i) sensor.taxel_ids.push_back(ids.item(i).small_integer());
  for (std::size_t i = 0; i < names.length(); ++i) sensor.taxel_names.push_back(names.item(i).text());
  return sensor;
}

Json scene_json(const EpisodeScene& scene) {
  Json sensors = Json::array();
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    Json one{{"sensor", scene.sensors[i]}};
    one.update(sensor_json(scene.layouts[i]));
    sensors.push_back(std::move(one));
  }
  return {{"key", scene.key},
          {"name", scene.name},
          {"sensors", std::move(sensors)},
          {"state", scene.state},
          {"state_unit", scene.state_unit},
          {"action", scene.action}};
}

std::vector<std::string> texts_at(const Node& node, const char* key) {
  const Node list = node.at(key);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < list.length(); ++i) texts.push_back(list.item(i).text());
  return texts;
}

EpisodeScene read_scene(const Node& node) {
  EpisodeScene scene;
  scene.key = node.at("key").text();
  scene.name = node.at("name").text();
  const Node sensors = node.at("sensors");
  for (std::size_t i = 0; i < sensors.length(); ++i) {
    scene.sensors.push_back(sensors.item(i).at("sensor").text());
    scene.layouts.push_back(read_sensor(sensors.item(i)));
  }
  scene.state = texts_at(node, "state");
  scene.state_unit = node.at("state_unit").text();
  scene.action = texts_at(node, "action");
  return scene;
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
    if (!outcome.summary.peak_sensor.empty()) one["peak_sensor"] = outcome.summary.peak_sensor;
  }
  Json json{{"version", kShardVersion}, {"group", head.group}, {"jobs", outcomes}};
  Json& columns = json["columns"] = Json::array();
  for (const ShardColumn& column : head.columns)
    columns.push_back(Json{{"name", column.name}, {"width", column.width}, {"is_list", column.is_list}});
  if (head.sensor) json["sensor"] = sensor_json(*head.sensor);
  if (head.scene) json["scene"] = scene_json(*head.scene);
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
  if (const auto scene = root.find("scene")) head.scene = read_scene(*scene);
  return head;
}

namespace {

constexpr const char* kFormat = "taxel-batch";
constexpr int kVersion = 1;
constexpr const char* kOfScenes = "scenes";  // kind of a batch whose jobs run scenes
constexpr int kFloat32 = 32, kFloat64 = 64;

Json changes_object(const std::vector<JobChange>& changes) {
  Json object = Json::object();
  for (const JobChange& change : changes) object[change.pointer] = Json::parse(change.value);
  return object;
}

}  // namespace

std::string episode_to_json(const EpisodeEntry& episode) {
  const bool is_of_scene = !episode.scene.empty();
  Json json{{"episode", episode.index},
            {"rows", episode.rows},
            {"shard", episode.shard},
            {"first_row", episode.first_row},
            {is_of_scene ? "of_scene" : "layout", episode.layout},
            {"task", episode.task},
            {"line", episode.line},
            {"number", episode.number},
            {"seed", episode.seed},
            {"job", episode.job},
            {"duration", episode.summary.duration},
            {"largest_force", episode.summary.largest_force},
            {"peak", episode.summary.peak},
            {"peak_taxel", episode.summary.peak_taxel}};
  if (is_of_scene) json["peak_sensor"] = episode.summary.peak_sensor;
  json["changes"] = changes_object(episode.changes);
  json[is_of_scene ? "scene" : "scenario"] = is_of_scene ? episode.scene : episode.scenario;
  return json_line(json);
}

std::string scene_entry_to_json(const EpisodeScene& scene) {
  return json_line(scene_json(scene));
}

std::string layout_entry_to_json(const EpisodeSensor& layout) {
  return json_line(sensor_json(layout));
}

std::string failed_to_jsonl(const std::vector<FailedJob>& failed, const std::vector<BrokenLine>& broken) {
  std::string text;
  for (const BrokenLine& line : broken) text += json_line(Json{{"line", line.line}, {"error", line.message}}) + "\n";
  for (const FailedJob& job : failed)
    text += json_line(Json{{"line", job.line},
                           {"number", job.number},
                           {"job", job.id},
                           {"error", job.error},
                           {"changes", changes_object(job.changes)}}) +
            "\n";
  return text;
}

std::string batch_to_json(const BatchPlan& plan, const BatchCounts& counts) {
  Json json{{"format", kFormat},
            {"version", kVersion},
            {"program", plan.program},
            {"jobs", plan.list.sha256},
            {"bits", plan.format.float64 ? kFloat64 : kFloat32},
            {"group_size", plan.format.group_size},
            {"episodes", counts.episodes},
            {"frames", counts.frames},
            {"failed", counts.failed.size()},
            {"poses", "x y z [m], then the quaternion w x y z"}};
  if (plan.format.fps > 0) json["fps"] = plan.format.fps;
  if (plan.list.of_scenes) json["runs"] = kOfScenes;
  return json_text(json);
}

namespace {

/// Returns the text of a file of the batch. Throws Error with the remedy if the file is missing.
std::string text_of(const fs::path& folder, const char* name) {
  const fs::path path = folder / name;
  std::error_code ignored;
  if (fs::exists(path, ignored)) return read_file(path);
  if (!fs::is_directory(folder, ignored)) throw Error(folder.string(), "no such folder");
  if (fs::exists(folder / ".batch", ignored))
    throw Error(path.string(), "no such file: the batch is not finished; run the same `taxel batch` command again");
  throw Error(path.string(), "no such file: the folder is no batch of `taxel batch`, or was copied in part");
}

void read_batch(const std::string& text, const std::string& file, BatchIndex& index) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const auto format = root.find("format"); !format || !format->is_text() || format->text() != kFormat)
    throw Error(file, "/format", "must be taxel-batch: the file does not describe a batch of `taxel batch`");
  if (const double version = root.at("version").number(); version != kVersion)
    throw Error(file, "/version",
                fmt::format("is {}, this program reads version {}: update this program", version, kVersion));
  if (const auto runs = root.find("runs"); runs && runs->is_text() && runs->text() == kOfScenes)
    throw Error(file, "/runs", "is scenes: read a batch of scenes in Python, by python -m taxel.data_set");
  index.program = root.at("program").text();
  index.bits = root.at("bits").small_integer();
  if (index.bits != kFloat32 && index.bits != kFloat64)
    throw Error(file, "/bits", fmt::format("must be 32 or 64, is {}", index.bits));
}

std::int64_t whole_at(const Node& node, const char* key) {
  return static_cast<std::int64_t>(node.at(key).natural());
}

std::vector<JobChange> changes_at(const Node& node) {
  const Node object = node.at("changes");
  object.must_be_object();
  std::vector<JobChange> changes;
  for (const auto& [pointer, value] : object.json().items()) changes.push_back({pointer, json_line(value)});
  return changes;
}

void read_episode(const Node& root, BatchIndex& index) {
  EpisodeEntry e;
  e.index = whole_at(root, "episode");
  e.rows = whole_at(root, "rows");
  e.shard = root.at("shard").text();
  e.first_row = whole_at(root, "first_row");
  e.layout = static_cast<std::size_t>(root.at("layout").natural());
  e.task = root.at("task").text();
  e.line = root.at("line").small_integer();
  e.number = whole_at(root, "number");
  e.seed = root.at("seed").natural();
  e.job = root.at("job").text();
  e.summary = read_summary(root);
  e.changes = changes_at(root);
  e.scenario = root.at("scenario").text();
  if (e.index != static_cast<std::int64_t>(index.episodes.size()))
    root.fail_at("episode", fmt::format("must be {}, the number of the line from 0", index.episodes.size()));
  if (e.rows == 0) root.fail_at("rows", "must be positive");
  if (e.layout >= index.layouts.size()) root.fail_at("layout", "is in no line of layouts.jsonl");
  const std::string name = fs::path(e.shard).filename().string();
  if (e.shard != "shards/" + name || name.empty()) root.fail_at("shard", "must be shards/NAME");
  index.episodes.push_back(std::move(e));
}

void read_failed(const Node& root, BatchIndex& index) {
  const int of_list = root.at("line").small_integer();
  const std::string error = root.at("error").text();
  if (!root.find("number")) return index.broken.push_back({of_list, error});
  index.failed.push_back({of_list, whole_at(root, "number"), root.at("job").text(), error, changes_at(root)});
}

/// Calls read(node) for each line that is not empty.
template <class Read>
void read_lines(const std::string& text, const fs::path& file, const Read& read) {
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) {
      const std::string place = fmt::format("{}: line {}", file.string(), number);
      const Json json = parse_json<Json>(text.substr(begin, end - begin), place);
      const Node root(json, place);
      root.must_be_object();
      read(root);
    }
    begin = end + 1;
  }
}

}  // namespace

BatchIndex parse_batch_index(const BatchTexts& texts, const fs::path& folder) {
  BatchIndex index;
  read_batch(texts.batch, (folder / kBatchFile).string(), index);
  read_lines(texts.layouts, folder / "layouts.jsonl",
             [&](const Node& root) { index.layouts.push_back(read_sensor(root)); });
  read_lines(texts.episodes, folder / "episodes.jsonl", [&](const Node& root) { read_episode(root, index); });
  read_lines(texts.failed, folder / "failed.jsonl", [&](const Node& root) { read_failed(root, index); });
  return index;
}

BatchIndex read_batch_index(const fs::path& folder) {
  BatchTexts texts;
  texts.batch = text_of(folder, kBatchFile);
  BatchIndex first;
  read_batch(texts.batch, (folder / kBatchFile).string(), first);  // a batch of scenes has no layouts.jsonl
  texts.episodes = text_of(folder, "episodes.jsonl");
  texts.layouts = text_of(folder, "layouts.jsonl");
  std::error_code ignored;
  if (fs::exists(folder / "failed.jsonl", ignored)) texts.failed = read_file(folder / "failed.jsonl");
  return parse_batch_index(texts, folder);
}

std::optional<double> number_of_json(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_number()) return std::nullopt;
  return json.get<double>();
}

}  // namespace taxel
