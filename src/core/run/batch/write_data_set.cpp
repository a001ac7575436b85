#include "core/run/batch/write_data_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/document/scenario/scenario.h"
#include "core/run/batch/data_set.h"
#include "core/run/batch/data_set_meta.h"

namespace taxel {
namespace {

/// The columns that the shards have, and the widths of their lists.
class ColumnPlan {
 public:
  void add(const ShardHead& shard) {
    for (const auto& [name, width] : shard.widths) {
      const auto [entry, is_new] = widths_.try_emplace(name, width);
      if (!is_new && entry->second != width) entry->second = -1;
      ++shards_of_[name];
    }
    ++shards_;
  }
  /// Returns the width of each column; -1 if it differs between rows, also if some shards do not have the column.
  [[nodiscard]] std::map<std::string, std::int64_t> widths() const {
    std::map<std::string, std::int64_t> widths = widths_;
    for (auto& [name, width] : widths)
      if (shards_of_.at(name) != shards_) width = -1;
    return widths;
  }

 private:
  std::map<std::string, std::int64_t> widths_;
  std::map<std::string, int> shards_of_;
  int shards_ = 0;
};

void survey_tasks(const DataSetPlan& plan, Survey& survey) {
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    for (std::size_t k = 0; k < plan.groups[g].jobs.size(); ++k) {
      if (!survey.heads[g].outcomes[k].error.empty()) continue;
      const std::string& task = plan.list.jobs[plan.groups[g].jobs[k]].task;
      const auto index = static_cast<std::int64_t>(survey.tasks.size());
      if (survey.task_indices.try_emplace(task, index).second) survey.tasks.push_back(task);
    }
  }
  survey.info.tasks = static_cast<std::int64_t>(survey.tasks.size());
}

/// Returns the common names of the taxels, or nothing if the layouts differ.
std::vector<std::string> common_taxels(const std::vector<EpisodeSensor>& sensors) {
  for (const EpisodeSensor& sensor : sensors)
    if (sensor.taxel_ids != sensors.front().taxel_ids || sensor.taxel_names != sensors.front().taxel_names) return {};
  std::vector<std::string> names;
  if (sensors.empty()) return names;
  const EpisodeSensor& first = sensors.front();
  for (std::size_t i = 0; i < first.taxel_ids.size(); ++i)
    names.push_back(first.taxel_names[i].empty() ? fmt::format("taxel_{}", first.taxel_ids[i]) : first.taxel_names[i]);
  return names;
}

/// Returns the unit of all layouts, or "mixed" (meta/layouts.parquet has the unit of each).
template <class Unit>
std::string common_unit(const std::vector<EpisodeSensor>& sensors, const Unit& unit) {
  for (const EpisodeSensor& sensor : sensors)
    if (unit(sensor) != unit(sensors.front())) return "mixed";
  return sensors.empty() ? "" : unit(sensors.front());
}

std::string unit_of(const std::string& column, const std::vector<EpisodeSensor>& sensors) {
  if (column == kTactile || column == kShear)
    return common_unit(sensors, [](const EpisodeSensor& sensor) { return sensor.unit; });
  if (column == kCalibrated)
    return common_unit(sensors, [](const EpisodeSensor& sensor) { return sensor.calibrated_unit; });
  const std::map<std::string, std::string> units{{kContactForce, "N"}, {kTravel, "m"}, {kTimestamp, "s"}};
  const auto unit = units.find(column);
  return unit != units.end() ? unit->second : std::string();
}

std::vector<std::string> components_of(const std::string& column, const std::vector<EpisodeSensor>& sensors) {
  if (column == kContactForce) return {"x", "y", "z"};
  if (column == kSensorPose || column == kMocapPose) return {"x", "y", "z", "qw", "qx", "qy", "qz"};
  if (column == kTactile || column == kCalibrated) return common_taxels(sensors);
  std::vector<std::string> components;
  if (column == kShear)
    for (const std::string& taxel : common_taxels(sensors))
      components.insert(components.end(), {taxel + " e1", taxel + " e2"});
  return components;
}

/// Returns the rate without the rounding of times.
double rate_of(double rows_per_second) {
  constexpr double kRounding = 1e-6;
  const double nearest = std::max(1.0, std::round(rows_per_second));
  return std::abs(rows_per_second - nearest) <= kRounding * nearest ? nearest : rows_per_second;
}

}  // namespace

void check_jobs(const JobList& list, const JobGroup& group, const ShardHead& head, const std::string& file) {
  bool is_same = head.group == group.id && head.outcomes.size() == group.jobs.size();
  for (std::size_t k = 0; is_same && k < group.jobs.size(); ++k)
    is_same = head.outcomes[k].id == list.jobs[group.jobs[k]].id;
  if (!is_same) throw Error(file, "has other jobs than its name says");
}

Survey survey_shards(const DataSetPlan& plan) {
  Survey survey;
  ColumnPlan columns;
  double duration = 0;
  std::map<std::string, std::size_t> sensor_of_key;
  for (const JobGroup& group : plan.groups) {
    const ParquetFile file(plan.shards / shard_name(group.id));
    ShardHead head = read_shard_head(file);
    check_jobs(plan.list, group, head, file.name());
    for (const JobOutcome& outcome : head.outcomes) {
      survey.info.episodes += outcome.rows > 0 ? 1 : 0;
      survey.info.frames += outcome.rows;
      duration += outcome.summary.duration;
    }
    survey.sensor_of_group.push_back(survey.sensors.size());
    if (head.sensor) {
      const auto [entry, is_new] = sensor_of_key.try_emplace(head.sensor->layout_key, survey.sensors.size());
      survey.sensor_of_group.back() = entry->second;
      if (is_new) survey.sensors.push_back(std::move(*head.sensor));
      head.sensor.reset();
    }
    if (file.rows() > 0) columns.add(head);
    survey.heads.push_back(std::move(head));
  }
  survey.widths = columns.widths();
  const double steps = static_cast<double>(survey.info.frames - survey.info.episodes);
  if (duration > 0) survey.info.rows_per_second = rate_of(steps / duration);
  if (plan.format.fps > 0) survey.info.rows_per_second = plan.format.fps;
  survey_tasks(plan, survey);
  return survey;
}

Feature feature_of(const std::string& name, const Survey& survey, const std::string& type) {
  return {name, type, survey.widths.at(name), components_of(name, survey.sensors), unit_of(name, survey.sensors)};
}

StreamedFile::StreamedFile(std::filesystem::path path) : path_(std::move(path)) {
  make_folder(path_.parent_path());
  file_ = os::File(path_, os::Open::create);
  if (!file_.is_open()) fail(file_.error());
}

void StreamedFile::fail(int why) const {
  throw Error(path_.string(), fmt::format("writing failed: {}", os::error_text(why)));
}

void StreamedFile::write(std::string_view bytes) {
  if (const int why = file_.write(bytes); why != 0) fail(why);
}

void StreamedFile::finish() {
  if (const int why = file_.sync(); why != 0) fail(why);
  file_.close();
}

namespace {

constexpr std::uint64_t kMaxDataFileBytes = std::uint64_t{100} << 20;

std::string chunk_path(int file) {
  return fmt::format("chunk-{:03}/file-{:03}.parquet", file / kFilesPerChunk, file % kFilesPerChunk);
}

}  // namespace

const std::vector<std::string> kRecordedColumns{kTactile, kContactForce, kCalibrated, kShear,
                                                kTravel,  kSensorPose,   kMocapPose,  kTimestamp};
const std::vector<std::string> kIndexColumns{"frame_index", "episode_index", "index", "task_index"};

RowFiles::RowFiles(std::filesystem::path folder, const DataSetPlan& plan, const Survey& survey)
    : folder_(std::move(folder)), plan_(plan), survey_(survey) {
  const ParquetType number = plan.format.float64 ? ParquetType::float64 : ParquetType::float32;
  for (const std::string& name : kRecordedColumns)
    if (survey.widths.contains(name)) columns_.push_back({name, number, name != kTimestamp && name != kTravel});
  for (const std::string& name : kIndexColumns) columns_.push_back({name, ParquetType::int64, false});
  for (const ParquetColumn& column : columns_) {
    const auto width = survey.widths.find(column.name);
    const std::int64_t count = width != survey.widths.end() ? std::max<std::int64_t>(1, width->second) : 1;
    statistics_.push_back({column.name, std::vector<ComponentStatistics>(static_cast<std::size_t>(count))});
  }
}

void RowFiles::add(std::size_t group) {
  const ParquetFile shard(plan_.shards / shard_name(plan_.groups[group].id));
  if (shard.rows() == 0) return;
  if (!writer_ || writer_->bytes() > kMaxDataFileBytes) begin_file();
  std::vector<EncodedColumn> encoded;
  const std::vector<ParquetCells> indices = index_cells(group);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t first_index = columns_.size() - kIndexColumns.size();
    encoded.push_back(i < first_index ? recorded(shard, i) : computed(i, indices[i - first_index]));
  }
  writer_->add(shard.rows(), encoded);
  ++row_group_;
}

void RowFiles::finish() {
  if (!writer_) return;
  writer_->finish({});
  file_->finish();
  writer_.reset();
}

void RowFiles::begin_file() {
  finish();
  ++file_number_;
  row_group_ = 0;
  file_ = std::make_unique<StreamedFile>(folder_ / "data" / chunk_path(file_number_));
  writer_ = std::make_unique<ParquetWriter>(columns_, [this](std::string_view bytes) { file_->write(bytes); });
}

EncodedColumn RowFiles::computed(std::size_t column, const ParquetCells& cells) {
  add_cells(cells, statistics_[column]);
  return encode_column(columns_[column], cells);
}

/// Returns the pages of a shard unchanged, or empty lists if the shard does not have the column.
EncodedColumn RowFiles::recorded(const ParquetFile& shard, std::size_t column) {
  const std::string& name = columns_[column].name;
  if (shard.has_column(name)) {
    add_cells(shard.cells(0, shard.column(name)), statistics_[column]);
    return shard.encoded(0, shard.column(name));
  }
  const std::vector<std::int32_t> lengths(static_cast<std::size_t>(shard.rows()), 0);
  return encode_column(columns_[column], plan_.format.float64 ? ParquetCells{std::vector<double>{}, lengths}
                                                              : ParquetCells{std::vector<float>{}, lengths});
}

/// Returns the cells of kIndexColumns.
std::vector<ParquetCells> RowFiles::index_cells(std::size_t group) {
  std::vector<std::int64_t> frame, episode, index, task;
  const std::vector<JobOutcome>& outcomes = survey_.heads[group].outcomes;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (outcomes[k].rows == 0) continue;
    const Job& job = plan_.list.jobs[plan_.groups[group].jobs[k]];
    for (std::int64_t row = 0; row < outcomes[k].rows; ++row) {
      frame.push_back(row);
      episode.push_back(episode_);
      index.push_back(frame_++);
      task.push_back(survey_.task_indices.at(job.task));
    }
    ++episode_;
  }
  return {{std::move(frame), {}}, {std::move(episode), {}}, {std::move(index), {}}, {std::move(task), {}}};
}

namespace {

constexpr std::size_t kEpisodesPerRowGroup = 1024;

std::vector<ParquetColumn> episode_columns() {
  std::vector<ParquetColumn> columns{{"tasks", ParquetType::text, true}};
  for (const char* name : kEpisodeNumbers) columns.push_back({name, ParquetType::int64, false});
  for (const char* name : kEpisodeTexts) columns.push_back({name, ParquetType::text, false});
  for (const char* name : kEpisodeValues) columns.push_back({name, ParquetType::float64, false});
  return columns;
}

}  // namespace

EpisodeFiles::EpisodeFiles(const std::filesystem::path& folder, const DataSetPlan& plan, const Survey& survey)
    : plan_(plan),
      survey_(survey),
      summary_(plan.list),
      csv_(folder / "summary.csv"),
      file_(folder / "meta/episodes/chunk-000/file-000.parquet"),
      writer_(episode_columns(), [this](std::string_view bytes) { file_.write(bytes); }) {
  csv_.write(summary_.head());
}

void EpisodeFiles::add(std::size_t group, const RowFiles& rows) {
  std::int64_t first_row = 0;
  for (std::size_t k = 0; k < plan_.groups[group].jobs.size(); ++k) {
    const JobOutcome& outcome = survey_.heads[group].outcomes[k];
    if (outcome.rows == 0) continue;
    const Job& job = plan_.list.jobs[plan_.groups[group].jobs[k]];
    csv_.write(summary_.line(episode_, job, outcome));
    add_numbers(outcome, rows, survey_.sensor_of_group[group], first_row, job);
    task_.push_back(job.task);
    texts_[0].push_back(job.id);
    texts_[1].push_back(scenario_to_json(job.scenario));
    texts_[2].push_back(changes_to_json(job.changes));
    const EpisodeSummary& s = outcome.summary;
    for (std::size_t i = 0; i < 3; ++i) values_[i].push_back(std::array{s.duration, s.largest_force, s.peak}[i]);
    first_row += outcome.rows;
    frame_ += outcome.rows;
    ++episode_;
    if (task_.size() == kEpisodesPerRowGroup) flush();
  }
}

void EpisodeFiles::finish() {
  flush();
  writer_.finish({});
  file_.finish();
  csv_.finish();
}

void EpisodeFiles::add_numbers(const JobOutcome& outcome, const RowFiles& rows, std::size_t sensor,
                               std::int64_t first_row, const Job& job) {
  const std::array<std::int64_t, kEpisodeNumbers.size()> numbers{episode_,
                                                                 outcome.rows,
                                                                 rows.file() / kFilesPerChunk,
                                                                 rows.file() % kFilesPerChunk,
                                                                 frame_,
                                                                 frame_ + outcome.rows,
                                                                 0,
                                                                 0,
                                                                 rows.row_group(),
                                                                 first_row,
                                                                 static_cast<std::int64_t>(sensor),
                                                                 job.line,
                                                                 job.number,
                                                                 static_cast<std::int64_t>(job.seed),
                                                                 outcome.summary.peak_taxel};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers_[i].push_back(numbers[i]);
}

void EpisodeFiles::flush() {
  if (task_.empty()) return;
  std::vector<ParquetCells> cells{lists_of(std::exchange(task_, {}), 1)};
  for (auto& numbers : numbers_) cells.push_back({std::exchange(numbers, {}), {}});
  for (auto& texts : texts_) cells.push_back({std::exchange(texts, {}), {}});
  for (auto& values : values_) cells.push_back({std::exchange(values, {}), {}});
  writer_.add(cells);
}

namespace {

namespace fs = std::filesystem;

void write_whole(const fs::path& path, std::string_view bytes) {
  StreamedFile file(path);
  file.write(bytes);
  file.finish();
}

void write_layouts(const fs::path& path, const std::vector<EpisodeSensor>& sensors) {
  std::vector<std::int64_t> ids;
  std::vector<std::string> keys, names, layouts, units, calibrated, taxels;
  std::vector<std::int32_t> counts;
  for (const EpisodeSensor& sensor : sensors) {
    keys.push_back(sensor.layout_key);
    names.push_back(sensor.layout_name);
    layouts.push_back(sensor.layout_json);
    units.push_back(sensor.unit);
    calibrated.push_back(sensor.calibrated_unit);
    ids.insert(ids.end(), sensor.taxel_ids.begin(), sensor.taxel_ids.end());
    taxels.insert(taxels.end(), sensor.taxel_names.begin(), sensor.taxel_names.end());
    counts.push_back(static_cast<std::int32_t>(sensor.taxel_ids.size()));
  }
  write_whole(
      path,
      parquet_bytes(
          {{"key", ParquetType::text},
           {"name", ParquetType::text},
           {"unit", ParquetType::text},
           {"calibrated_unit", ParquetType::text},
           {"taxel_ids", ParquetType::int64, true},
           {"taxel_names", ParquetType::text, true},
           {"layout", ParquetType::text}},
          {{keys, {}}, {names, {}}, {units, {}}, {calibrated, {}}, {ids, counts}, {taxels, counts}, {layouts, {}}}));
}

std::vector<FailedJob> failed_jobs(const DataSetPlan& plan, const Survey& survey) {
  std::vector<std::string> errors;
  for (const Job& job : plan.list.jobs) errors.push_back(job.error);
  for (std::size_t g = 0; g < plan.groups.size(); ++g)
    for (std::size_t k = 0; k < plan.groups[g].jobs.size(); ++k)
      errors[plan.groups[g].jobs[k]] = survey.heads[g].outcomes[k].error;
  std::vector<FailedJob> failed;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Job& job = plan.list.jobs[i];
    if (!errors[i].empty()) failed.push_back({job.line, job.number, job.id, errors[i], job.changes});
  }
  return failed;
}

void write_meta(const fs::path& folder, const DataSetPlan& plan, Survey& survey, const std::string& statistics,
                const std::vector<FailedJob>& failed) {
  for (const std::string& name : kRecordedColumns)
    if (survey.widths.contains(name))
      survey.info.features.push_back(feature_of(name, survey, plan.format.float64 ? "float64" : "float32"));
  for (const std::string& name : kIndexColumns) survey.info.features.push_back({name, "int64", 1, {}, ""});
  std::vector<std::int64_t> indices;
  for (std::size_t i = 0; i < survey.tasks.size(); ++i) indices.push_back(static_cast<std::int64_t>(i));
  write_whole(folder / "tasks.parquet",
              parquet_bytes({{"task_index", ParquetType::int64}, {"__index_level_0__", ParquetType::text}},
                            {{indices, {}}, {survey.tasks, {}}}, {{"pandas", task_index_note()}}));
  write_layouts(folder / "layouts.parquet", survey.sensors);
  write_whole(folder / "stats.json", statistics);
  write_whole(folder / "taxel.json", data_set_to_json(plan, survey.info, failed.size()));
  const std::string reasons = failed_to_jsonl(failed, plan.list.broken);
  if (!reasons.empty()) write_whole(folder / "failed.jsonl", reasons);
  write_whole(folder / "info.json", info_to_json(survey.info));
}

}  // namespace

std::string shard_name(const std::string& group) {
  return group + ".parquet";
}

DataSetCounts write_data_set(const fs::path& folder, const DataSetPlan& plan,
                             const std::function<void(double)>& on_progress) {
  Survey survey = survey_shards(plan);
  RowFiles rows(folder, plan, survey);
  EpisodeFiles episodes(folder, plan, survey);
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    on_progress(static_cast<double>(g) / static_cast<double>(plan.groups.size()));
    rows.add(g);
    episodes.add(g, rows);
  }
  rows.finish();
  episodes.finish();
  std::vector<FailedJob> failed = failed_jobs(plan, survey);
  write_meta(folder / "meta", plan, survey, rows.statistics_json(), failed);
  return {survey.info.episodes, survey.info.frames, std::move(failed)};
}

}  // namespace taxel
