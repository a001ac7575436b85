// The texts of the index of a batch, written and read.
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/run/batch/batch_index.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr const char* kFormat = "taxel-batch";
constexpr int kVersion = 1;
constexpr int kFloat32 = 32, kFloat64 = 64;

Json changes_object(const std::vector<JobChange>& changes) {
  Json object = Json::object();
  for (const JobChange& change : changes) object[change.pointer] = Json::parse(change.value);
  return object;
}

}  // namespace

std::string episode_to_json(const EpisodeEntry& episode) {
  return json_line(Json{{"episode", episode.index},
                        {"rows", episode.rows},
                        {"shard", episode.shard},
                        {"first_row", episode.first_row},
                        {"layout", episode.layout},
                        {"task", episode.task},
                        {"line", episode.line},
                        {"number", episode.number},
                        {"seed", episode.seed},
                        {"job", episode.job},
                        {"duration", episode.summary.duration},
                        {"largest_force", episode.summary.largest_force},
                        {"peak", episode.summary.peak},
                        {"peak_taxel", episode.summary.peak_taxel},
                        {"changes", changes_object(episode.changes)},
                        {"scenario", episode.scenario}});
}

std::string layout_entry_to_json(const EpisodeSensor& layout) {
  return json_line(Json{{"key", layout.layout_key},
                        {"name", layout.layout_name},
                        {"unit", layout.unit},
                        {"calibrated_unit", layout.calibrated_unit},
                        {"taxel_ids", layout.taxel_ids},
                        {"taxel_names", layout.taxel_names},
                        {"layout", layout.layout_json}});
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
  index.program = root.at("program").text();
  index.bits = root.at("bits").small_integer();
  if (index.bits != kFloat32 && index.bits != kFloat64)
    throw Error(file, "/bits", fmt::format("must be 32 or 64, is {}", index.bits));
}

std::int64_t whole_at(const Node& node, const char* key) {
  return static_cast<std::int64_t>(node.at(key).natural());
}

std::vector<JobChange> changes_at(const Node& node, const Json& json) {
  node.at("changes").must_be_object();
  std::vector<JobChange> changes;
  for (const auto& [pointer, value] : json["changes"].items()) changes.push_back({pointer, json_line(value)});
  return changes;
}

void read_episode(const Json& json, const Node& root, BatchIndex& index) {
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
  e.summary = {root.at("largest_force").number(), root.at("peak").number(), root.at("peak_taxel").small_integer(),
               root.at("duration").number()};
  e.changes = changes_at(root, json);
  e.scenario = root.at("scenario").text();
  if (e.index != static_cast<std::int64_t>(index.episodes.size()))
    root.fail_at("episode", fmt::format("must be {}, the number of the line from 0", index.episodes.size()));
  if (e.rows == 0) root.fail_at("rows", "must be positive");
  if (e.layout >= index.layouts.size()) root.fail_at("layout", "is in no line of layouts.jsonl");
  const std::string name = fs::path(e.shard).filename().string();
  if (e.shard != "shards/" + name || name.empty()) root.fail_at("shard", "must be shards/NAME");
  index.episodes.push_back(std::move(e));
}

void read_layout(const Node& root, BatchIndex& index) {
  EpisodeSensor layout;
  layout.layout_key = root.at("key").text();
  layout.layout_name = root.at("name").text();
  layout.unit = root.at("unit").text();
  layout.calibrated_unit = root.at("calibrated_unit").text();
  layout.layout_json = root.at("layout").text();
  const Node ids = root.at("taxel_ids"), names = root.at("taxel_names");
  if (names.length() != ids.length()) names.fail("must have as many texts as taxel_ids");
  for (std::size_t i = 0; i < ids.length(); ++i) layout.taxel_ids.push_back(ids.item(i).small_integer());
  for (std::size_t i = 0; i < names.length(); ++i) layout.taxel_names.push_back(names.item(i).text());
  index.layouts.push_back(std::move(layout));
}

void read_failed(const Json& json, const Node& root, BatchIndex& index) {
  const int of_list = root.at("line").small_integer();
  const std::string error = root.at("error").text();
  if (!root.find("number")) return index.broken.push_back({of_list, error});
  index.failed.push_back({of_list, whole_at(root, "number"), root.at("job").text(), error, changes_at(root, json)});
}

/// Calls read(json, node) for each line that is not empty.
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
      read(json, root);
    }
    begin = end + 1;
  }
}

}  // namespace

BatchIndex parse_batch_index(const BatchTexts& texts, const fs::path& folder) {
  BatchIndex index;
  read_batch(texts.batch, (folder / kBatchFile).string(), index);
  read_lines(texts.layouts, folder / "layouts.jsonl", [&](const Json&, const Node& root) { read_layout(root, index); });
  read_lines(texts.episodes, folder / "episodes.jsonl",
             [&](const Json& json, const Node& root) { read_episode(json, root, index); });
  read_lines(texts.failed, folder / "failed.jsonl",
             [&](const Json& json, const Node& root) { read_failed(json, root, index); });
  return index;
}

BatchIndex read_batch_index(const fs::path& folder) {
  BatchTexts texts;
  texts.batch = text_of(folder, kBatchFile);
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
