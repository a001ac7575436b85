// A data set of episodes in the shape of LeRobot's version 3 (https://huggingface.co/docs/lerobot/lerobot-dataset-v3),
// with the layouts, jobs and units of this program in addition.
//
//   data/chunk-000/file-000.parquet           rows: timestamp, observation.*, and indices; a row group for each group
//   meta/info.json, stats.json, tasks.parquet shapes and names of the columns, their statistics, and the tasks
//   meta/episodes/chunk-000/file-000.parquet  a row for each episode: its place, its job, and a summary
//   meta/layouts.parquet                      the layouts, with the order and the unit of their taxels
//   meta/taxel.json                           versions, units and counts
//   meta/failed.jsonl                         jobs without an episode, and the reasons
//   summary.csv                               a line for each episode with its changed parameters
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/document/batch/job.h"
#include "core/document/scenario/study.h"
#include "core/run/batch/episode.h"
#include "core/run/batch/shard.h"
#include "core/run/step.h"

namespace taxel {

/// The parts of a data set that is to be written.
struct DataSetPlan {
  const JobList& list;
  const std::vector<JobGroup>& groups;
  std::filesystem::path shards;  ///< folder of the shards
  BatchFormat format;
  std::string program;  ///< versions of the program and of MuJoCo
};

/// A job without an episode.
struct FailedJob {
  int line = 0;
  std::int64_t number = 0;  ///< Job::number
  std::string id;           ///< empty if the job has no valid content
  std::string error;
  std::vector<JobChange> changes;
};

struct DataSetCounts {
  std::int64_t episodes = 0, frames = 0;
  std::vector<FailedJob> failed;  ///< in the order of the list
};

/// Returns the name of a group's shard in the folder of shards.
std::string shard_name(const std::string& group);

/// Writes the data set of finished groups into an empty folder. Memory does not grow with the number of rows. Equal
/// shards give equal bytes. Calls on_progress(fraction), which may throw. Throws Error if a shard cannot be read or a
/// file cannot be written.
DataSetCounts write_data_set(const std::filesystem::path& folder, const DataSetPlan& plan,
                             const std::function<void(double)>& on_progress);

/// An episode of a data set that is read.
struct EpisodeEntry {
  std::int64_t index = 0, rows = 0;
  std::string task;
  std::string job;         ///< Job::id
  int line = 0;            ///< line in the list of jobs
  std::int64_t seed = 0;   ///< Job::seed
  std::size_t layout = 0;  ///< index of DataSet::layouts()
  std::string scenario;    ///< JSON text, with which the episode can be played again
  std::string changes;     ///< JSON object: changed values by JSON pointer
  EpisodeSummary summary;
  std::string file;            ///< path below the folder
  std::size_t row_group = 0;   ///< row group of the file
  std::int64_t first_row = 0;  ///< first row in the row group
};

/// A data set of `taxel batch` on the disk.
class DataSet {
 public:
  /// Reads everything but the rows. Throws Error naming the file that is missing, damaged or not of a data set.
  explicit DataSet(const std::filesystem::path& folder);

  [[nodiscard]] const std::vector<EpisodeEntry>& episodes() const { return episodes_; }
  [[nodiscard]] const std::vector<EpisodeSensor>& layouts() const { return layouts_; }
  /// Reads the rows of an episode. The columns are those of episode_of(); numbers of 32 bits are widened. Throws Error
  /// naming the file.
  [[nodiscard]] Episode read_episode(std::size_t index) const;

 private:
  void read_layouts();
  void read_episodes();

  std::filesystem::path folder_;
  std::vector<EpisodeEntry> episodes_;
  std::vector<EpisodeSensor> layouts_;
};

/// Result of comparing the first rows of a run with the episode of a data set that it repeats.
struct ReplayCheck {
  std::uint64_t edition = 0;       ///< edition of the trace that was compared
  std::size_t rows = 0;            ///< number of compared rows
  std::size_t different_rows = 0;  ///< rows in which a reading, the time or the travel has other bits
  double largest = 0;              ///< largest difference of a reading [unit of the readings]
  std::size_t largest_taxel = 0;   ///< index of the taxel with the largest difference
  double largest_time = 0;         ///< time of the episode's row with the largest difference [s]
  bool has_other_times = false;    ///< a time or a travel differs
  bool has_preview = false;        ///< a row was read with preview samples
  std::string problem;             ///< reason why the rows cannot be compared, or empty
  bool operator==(const ReplayCheck&) const = default;
};

/// Continues a comparison with the rows that a run has got since. Begins again if rows were removed. Readings, time and
/// travel are compared by their bits, with `bits` = 32 after rounding to 32 bits. Rows behind the end of the episode
/// count as different.
void compare_with_episode(const Trace& trace, const Episode& episode, int bits, ReplayCheck& check);

// Parameter studies as data sets: a study is one line of a list of jobs, and its data set is read as a study again.

/// Returns the line of a list of jobs that gives the runs of a study of the default layout (core/document/batch).
std::string job_line_of(const Study& study);

/// Reads a data set as the runs of a study. One or two numbers vary: numbers of the scenario, or density and seed of
/// the samples. If one or two numbers are changed, they need not vary. Each combination of their values has one episode
/// or one failed job. The values are in ascending order. Throws Error naming the folder, the parameter and the remedy
/// if the data set is no study, and the errors of DataSet and read_data_set_head(); throws Cancelled.
StudyCurves read_study_of_data_set(const std::filesystem::path& folder, Progress& progress);

}  // namespace taxel
