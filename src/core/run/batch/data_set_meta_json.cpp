#include <nlohmann/json.hpp>

#include <algorithm>

#include "core/base/text/json_text.h"
#include "core/run/batch/data_set_meta.h"

namespace taxel {
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

}  // namespace taxel
