#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/run/batch/data_set_meta.h"

namespace taxel {

void ComponentStatistics::add(double value) {
  min = std::min(min, value);
  max = std::max(max, value);
  ++count;
  const double before = value - mean;
  mean += before / static_cast<double>(count);
  squares += before * (value - mean);
}

void add_cells(const ParquetCells& cells, ColumnStatistics& statistics) {
  const std::size_t width = statistics.components.size();
  const auto add = [&]<class Value>(const std::vector<Value>& values) {
    if constexpr (!std::is_same_v<Value, std::string>)
      for (std::size_t i = 0; i < values.size(); ++i)
        statistics.components[i % width].add(static_cast<double>(values[i]));
  };
  if (width > 0) std::visit(add, cells.values);
}

std::string statistics_to_json(const std::vector<ColumnStatistics>& columns) {
  using Json = nlohmann::ordered_json;
  Json all = Json::object();
  for (const ColumnStatistics& column : columns) {
    if (column.components.empty() || column.components.front().count == 0) continue;
    Json min = Json::array(), max = Json::array(), mean = Json::array(), deviation = Json::array();
    for (const ComponentStatistics& component : column.components) {
      min.push_back(component.min);
      max.push_back(component.max);
      mean.push_back(component.mean);
      deviation.push_back(std::sqrt(component.squares / static_cast<double>(component.count)));
    }
    all[column.name] = {
        {"min", min}, {"max", max}, {"mean", mean}, {"std", deviation}, {"count", {column.components.front().count}}};
  }
  return json_text(all);
}

namespace {

using Json = nlohmann::ordered_json;

/// Returns a cell of a CSV file, quoted where needed (RFC 4180).
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// Returns a whole rate as a whole number, as other programs write it.
Json rate_json(double rows_per_second) {
  const auto whole = static_cast<std::int64_t>(rows_per_second);
  return static_cast<double>(whole) == rows_per_second ? Json(whole) : Json(rows_per_second);
}

Json changes_object(const std::vector<JobChange>& changes) {
  Json object = Json::object();
  for (const JobChange& change : changes) object[change.pointer] = Json::parse(change.value);
  return object;
}

}  // namespace

std::string info_to_json(const DataSetInfo& info) {
  Json features = Json::object();
  for (const Feature& feature : info.features) {
    Json& one = features[feature.name] = {{"dtype", feature.type}, {"shape", {feature.width}}};
    one["names"] = feature.components.empty() ? Json(nullptr) : Json(feature.components);
    if (!feature.unit.empty()) one["unit"] = feature.unit;
  }
  // The keys are those of LeRobot's version 3.
  return json_text(Json{{"codebase_version", "v3.0"},
                        {"robot_type", "taxel"},
                        {"total_episodes", info.episodes},
                        {"total_frames", info.frames},
                        {"total_tasks", info.tasks},
                        {"chunks_size", 1000},
                        {"data_files_size_in_mb", 100},
                        {"video_files_size_in_mb", 200},
                        {"fps", rate_json(info.rows_per_second)},
                        {"splits", {{"train", fmt::format("0:{}", info.episodes)}}},
                        {"data_path", "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"},
                        {"video_path", nullptr},
                        {"features", features}});
}

std::string data_set_to_json(const DataSetPlan& plan, const DataSetInfo& info, std::size_t failed) {
  Json units = Json::object();
  for (const Feature& feature : info.features)
    if (!feature.unit.empty()) units[feature.name] = feature.unit;
  Json json{{"format", "taxel-data-set"},
            {"version", 1},
            {"program", plan.program},
            {"jobs", plan.list.sha256},
            {"bits", plan.format.float64 ? 64 : 32},
            {"group_size", plan.format.group_size},
            {"episodes", info.episodes},
            {"frames", info.frames},
            {"failed", failed},
            {"units", units},
            {"poses", "x y z [m], then the quaternion w x y z"}};
  if (plan.format.fps > 0) json["fps"] = plan.format.fps;
  return json_text(json);
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

std::string changes_to_json(const std::vector<JobChange>& changes) {
  return json_line(changes_object(changes));
}

std::string task_index_note() {
  const Json text_column{{"name", nullptr},
                         {"field_name", "__index_level_0__"},
                         {"pandas_type", "unicode"},
                         {"numpy_type", "object"},
                         {"metadata", nullptr}};
  const Json number_column{{"name", "task_index"},
                           {"field_name", "task_index"},
                           {"pandas_type", "int64"},
                           {"numpy_type", "int64"},
                           {"metadata", nullptr}};
  const Json names{{"name", nullptr},
                   {"field_name", nullptr},
                   {"pandas_type", "unicode"},
                   {"numpy_type", "object"},
                   {"metadata", {{"encoding", "UTF-8"}}}};
  return json_line(Json{{"index_columns", {"__index_level_0__"}},
                        {"column_indexes", Json::array({names})},
                        {"columns", Json::array({number_column, text_column})},
                        {"creator", {{"library", "taxel"}, {"version", "1"}}},
                        {"pandas_version", "2.2.0"}});
}

SummaryTable::SummaryTable(const JobList& list) {
  for (const Job& job : list.jobs)
    for (const JobChange& change : job.changes)
      if (std::ranges::find(pointers_, change.pointer) == pointers_.end()) pointers_.push_back(change.pointer);
}

std::string SummaryTable::head() const {
  std::string text = "episode,line,number,seed,task";
  for (const std::string& pointer : pointers_) text += "," + csv_cell(pointer);
  return text + ",rows,duration,largest_force,peak,peak_taxel,job\n";
}

std::string SummaryTable::line(std::int64_t episode, const Job& job, const JobOutcome& outcome) const {
  std::string text = fmt::format("{},{},{},{},{}", episode, job.line, job.number, job.seed, csv_cell(job.task));
  for (const std::string& pointer : pointers_) {
    const auto change = std::ranges::find(job.changes, pointer, &JobChange::pointer);
    text += "," + (change != job.changes.end() ? csv_cell(change->value) : std::string());
  }
  const EpisodeSummary& s = outcome.summary;
  return text +
         fmt::format(",{},{},{},{},{},{}\n", outcome.rows, s.duration, s.largest_force, s.peak, s.peak_taxel, job.id);
}

namespace {

namespace fs = std::filesystem;

using Node = JsonNode<Json>;

constexpr const char* kEpisodesVersion = "v3.0";
constexpr int kDataSetVersion = 1;
constexpr int kFloat32 = 32, kFloat64 = 64;

/// Returns the text of a file of the data set. Throws Error with the remedy if the file is missing.
std::string text_of(const fs::path& folder, const char* name) {
  const fs::path path = folder / name;
  std::error_code ignored;
  if (fs::exists(path, ignored)) return read_file(path);
  if (!fs::is_directory(folder, ignored)) throw Error(folder.string(), "no such folder");
  if (fs::exists(folder / ".batch", ignored))
    throw Error(path.string(), "no such file: the batch is not finished; run the same `taxel batch` command again");
  if (name == std::string_view(kDataSetHeadFile))
    throw Error(
        path.string(),
        "no such file: only data sets of `taxel batch` hold the jobs of their episodes; make one by that command");
  throw Error(path.string(), "no such file: the folder is no data set of `taxel batch`, or was copied in part");
}

void check_info(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const std::string version = root.at("codebase_version").text(); version != kEpisodesVersion)
    throw Error(file, "/codebase_version",
                fmt::format("is {}, this program reads {}: write the data set by `taxel batch` of this version",
                            short_quote(version), kEpisodesVersion));
}

void read_head(const std::string& text, const std::string& file, DataSetHead& head) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const auto format = root.find("format"); !format || !format->is_text() || format->text() != "taxel-data-set")
    throw Error(file, "/format", "must be taxel-data-set: the file does not describe a data set of `taxel batch`");
  if (const double version = root.at("version").number(); version != kDataSetVersion)
    throw Error(file, "/version",
                fmt::format("is {}, this program reads version {}: update this program", version, kDataSetVersion));
  head.program = root.at("program").text();
  head.bits = root.at("bits").small_integer();
  if (head.bits != kFloat32 && head.bits != kFloat64)
    throw Error(file, "/bits", fmt::format("must be 32 or 64, is {}", head.bits));
  head.episodes = static_cast<std::int64_t>(root.at("episodes").natural());
}

std::vector<JobChange> changes_of(const Json& json) {
  std::vector<JobChange> changes;
  for (const auto& [pointer, value] : json.items()) changes.push_back({pointer, json_line(value)});
  return changes;
}

void read_failed(const std::string& line, const std::string& file, std::size_t number, DataSetHead& head) {
  const std::string place = fmt::format("{}: line {}", file, number);
  const Json json = parse_json<Json>(line, place);
  const Node root(json, place);
  root.must_be_object();
  const int of_list = root.at("line").small_integer();
  const std::string error = root.at("error").text();
  if (!root.find("number")) return head.broken.push_back({of_list, error});
  FailedJob job{of_list, static_cast<std::int64_t>(root.at("number").natural()), root.at("job").text(), error, {}};
  root.at("changes").must_be_object();
  job.changes = changes_of(json["changes"]);
  head.failed.push_back(std::move(job));
}

}  // namespace

DataSetHead parse_data_set_head(const DataSetTexts& texts, const fs::path& folder) {
  DataSetHead head;
  check_info(texts.info, (folder / kDataSetInfoFile).string());
  read_head(texts.head, (folder / kDataSetHeadFile).string(), head);
  const std::string& text = texts.failed;
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) read_failed(text.substr(begin, end - begin), (folder / kFailedJobsFile).string(), number, head);
    begin = end + 1;
  }
  return head;
}

DataSetHead read_data_set_head(const fs::path& folder) {
  DataSetTexts texts{text_of(folder, kDataSetInfoFile), text_of(folder, kDataSetHeadFile), ""};
  std::error_code ignored;
  if (fs::exists(folder / kFailedJobsFile, ignored)) texts.failed = read_file(folder / kFailedJobsFile);
  return parse_data_set_head(texts, folder);
}

std::vector<JobChange> parse_changes(const std::string& text, const std::string& file, const std::string& where) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw Error(file, where, "must be a JSON object, is " + short_quote(text));
  return changes_of(json);
}

std::optional<double> number_of_json(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_number()) return std::nullopt;
  return json.get<double>();
}

}  // namespace taxel
