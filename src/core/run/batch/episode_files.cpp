#include "core/run/batch/episode_files.h"

#include <utility>

#include "core/document/scenario/scenario_json.h"

namespace taxel {
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

}  // namespace taxel
