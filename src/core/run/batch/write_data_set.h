// The parts of write_data_set(): the survey of the shards, the files of rows, and the table of episodes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/os/file.h"
#include "core/run/batch/data_set.h"
#include "core/run/batch/data_set_meta.h"

namespace taxel {

/// The shards of a batch as a whole: everything that a data set needs before its rows are written.
struct Survey {
  std::vector<ShardHead> heads;              ///< parallel to the groups; without the sensors
  std::vector<EpisodeSensor> sensors;        ///< each layout once
  std::vector<std::size_t> sensor_of_group;  ///< index of `sensors`
  std::vector<std::string> tasks;
  std::map<std::string, std::int64_t> task_indices;
  std::map<std::string, std::int64_t> widths;  ///< values in a row of each column; -1 if it differs between rows
  DataSetInfo info;
};

/// Reads the descriptions of all shards. Throws Error naming a shard that cannot be read or has other jobs.
Survey survey_shards(const DataSetPlan& plan);

/// Throws Error naming `file` unless a shard has the jobs of its group.
void check_jobs(const JobList& list, const JobGroup& group, const ShardHead& head, const std::string& file);

/// Returns a column of the rows as a feature. `type` is the type of its numbers.
Feature feature_of(const std::string& name, const Survey& survey, const std::string& type);

/// A file that is written piece by piece. Writes into a folder that the caller moves to its place when all files are
/// complete.
class StreamedFile {
 public:
  /// Creates the file and its folders. Throws Error naming the file.
  explicit StreamedFile(std::filesystem::path path);
  /// Throws Error naming the file if the bytes cannot be written.
  void write(std::string_view bytes);
  /// Waits until all bytes are on the disk, and closes the file. Throws Error naming the file.
  void finish();

 private:
  [[noreturn]] void fail(int why) const;

  std::filesystem::path path_;
  os::File file_;
};

/// Columns that are recorded, and those that are computed from the place of a row, in the order of the files.
extern const std::vector<std::string> kRecordedColumns, kIndexColumns;

inline constexpr int kFilesPerChunk = 1000;

/// Writes the rows group by group. Recorded columns are copied from the shards as they are compressed.
class RowFiles {
 public:
  /// `plan` and `survey` must outlive the object.
  RowFiles(std::filesystem::path folder, const DataSetPlan& plan, const Survey& survey);

  /// Adds the rows of a group. Groups are added in order. Throws Error naming a file.
  void add(std::size_t group);
  void finish();
  [[nodiscard]] int file() const { return file_number_; }
  [[nodiscard]] std::int64_t row_group() const { return row_group_ - 1; }  ///< row group of the latest group
  [[nodiscard]] std::string statistics_json() const { return statistics_to_json(statistics_); }

 private:
  void begin_file();
  EncodedColumn computed(std::size_t column, const ParquetCells& cells);
  EncodedColumn recorded(const ParquetFile& shard, std::size_t column);
  std::vector<ParquetCells> index_cells(std::size_t group);

  std::filesystem::path folder_;
  const DataSetPlan& plan_;
  const Survey& survey_;
  std::vector<ParquetColumn> columns_;
  std::vector<ColumnStatistics> statistics_;  // parallel to columns_
  std::unique_ptr<StreamedFile> file_;
  std::unique_ptr<ParquetWriter> writer_;
  int file_number_ = -1;
  std::int64_t row_group_ = 0, episode_ = 0, frame_ = 0;
};

/// Columns of the table of episodes, after `tasks`. The first eight are LeRobot's.
inline constexpr std::array kEpisodeNumbers{"episode_index",
                                            "length",
                                            "data/chunk_index",
                                            "data/file_index",
                                            "dataset_from_index",
                                            "dataset_to_index",
                                            "meta/episodes/chunk_index",
                                            "meta/episodes/file_index",
                                            "taxel/row_group",
                                            "taxel/first_row",
                                            "taxel/layout",
                                            "taxel/line",
                                            "taxel/number",
                                            "taxel/seed",
                                            "taxel/peak_taxel"};
inline constexpr std::array kEpisodeTexts{"taxel/job", "taxel/scenario", "taxel/changes"};
inline constexpr std::array kEpisodeValues{"taxel/duration", "taxel/largest_force", "taxel/peak"};

/// Writes the table of episodes, and summary.csv: a row for each episode, group by group.
class EpisodeFiles {
 public:
  /// `plan` and `survey` must outlive the object.
  EpisodeFiles(const std::filesystem::path& folder, const DataSetPlan& plan, const Survey& survey);

  /// Adds the episodes of a group, whose rows were added to `rows` last.
  void add(std::size_t group, const RowFiles& rows);
  void finish();

 private:
  void add_numbers(const JobOutcome& outcome, const RowFiles& rows, std::size_t sensor, std::int64_t first_row,
                   const Job& job);
  void flush();

  const DataSetPlan& plan_;
  const Survey& survey_;
  SummaryTable summary_;
  StreamedFile csv_, file_;
  ParquetWriter writer_;
  std::int64_t episode_ = 0, frame_ = 0;
  std::vector<std::string> task_;
  std::array<std::vector<std::int64_t>, kEpisodeNumbers.size()> numbers_;
  std::array<std::vector<std::string>, kEpisodeTexts.size()> texts_;
  std::array<std::vector<double>, kEpisodeValues.size()> values_;
};

}  // namespace taxel
