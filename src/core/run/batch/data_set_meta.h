// The JSON and CSV texts of a data set, written and read: its columns with their statistics, the program that wrote it,
// and the jobs without an episode.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/document/batch/job.h"
#include "core/run/batch/data_set.h"
#include "core/run/parquet/parquet.h"

namespace taxel {

/// Statistics of one component of a column, with which learners scale their inputs.
struct ComponentStatistics {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  double mean = 0;
  double squares = 0;  ///< sum of the squared differences from the mean
  std::int64_t count = 0;

  /// Follows one value (Welford 1962).
  void add(double value);
};

struct ColumnStatistics {
  std::string name;
  std::vector<ComponentStatistics> components;
};

/// Adds cells to the statistics of a column. With as many components as each row has values, a component follows its
/// place in the rows; with one component, it follows all values.
void add_cells(const ParquetCells& cells, ColumnStatistics& statistics);

/// Returns the text of meta/stats.json. Columns without values are left out.
std::string statistics_to_json(const std::vector<ColumnStatistics>& columns);

/// A feature of meta/info.json: a column of the rows.
struct Feature {
  std::string name;
  std::string type;                     ///< float32, float64 or int64
  std::int64_t width = 1;               ///< number of values in a row; -1 if it differs between rows
  std::vector<std::string> components;  ///< names of the values; may be empty
  std::string unit;                     ///< empty for indices
};

/// The numbers of a data set.
struct DataSetInfo {
  std::vector<Feature> features;
  std::int64_t episodes = 0, frames = 0, tasks = 0;
  double rows_per_second = 1;
};

std::string info_to_json(const DataSetInfo& info);

/// Returns the text of meta/taxel.json.
std::string data_set_to_json(const DataSetPlan& plan, const DataSetInfo& info, std::size_t failed);

/// Returns meta/failed.jsonl: a JSON object on a line for each job and each broken line without an episode.
std::string failed_to_jsonl(const std::vector<FailedJob>& failed, const std::vector<BrokenLine>& broken);

/// Returns changes as a JSON object: values by JSON pointer.
std::string changes_to_json(const std::vector<JobChange>& changes);

/// Returns the text with which pandas finds the index of a table of tasks.
std::string task_index_note();

/// The lines of summary.csv.
class SummaryTable {
 public:
  /// Takes the columns of all parameters that the jobs of a list change.
  explicit SummaryTable(const JobList& list);
  [[nodiscard]] std::string head() const;
  [[nodiscard]] std::string line(std::int64_t episode, const Job& job, const JobOutcome& outcome) const;

 private:
  std::vector<std::string> pointers_;
};

/// Files of every data set, below its folder.
inline constexpr const char* kDataSetInfoFile = "meta/info.json";
inline constexpr const char* kDataSetHeadFile = "meta/taxel.json";
inline constexpr const char* kFailedJobsFile = "meta/failed.jsonl";

/// The description of a data set of `taxel batch`.
struct DataSetHead {
  std::string program;             ///< versions of the program and of MuJoCo
  int bits = 32;                   ///< bits of the numbers of the rows: 32 or 64
  std::int64_t episodes = 0;       ///< number of episodes
  std::vector<FailedJob> failed;   ///< jobs without an episode
  std::vector<BrokenLine> broken;  ///< lines of the list that gave no jobs
};

/// The texts of the files that describe a data set.
struct DataSetTexts {
  std::string info, head, failed;  ///< `failed` is empty if all jobs have an episode
};

/// Parses the texts. `folder` is the data set's in messages. Throws Error naming file, line and JSON pointer.
DataSetHead parse_data_set_head(const DataSetTexts& texts, const std::filesystem::path& folder);

/// Reads the description of the data set in a folder. Throws Error naming the file: it is missing, damaged, or of
/// another program or a newer version. The message says how to repair the data set.
DataSetHead read_data_set_head(const std::filesystem::path& folder);

/// Parses the changed values of an episode or a failed job: a JSON object with values by JSON pointer. Throws
/// Error(file, where, ...).
std::vector<JobChange> parse_changes(const std::string& text, const std::string& file, const std::string& where);

/// Returns the number in a JSON text, or nothing if the text is not one number.
std::optional<double> number_of_json(const std::string& text);

}  // namespace taxel
