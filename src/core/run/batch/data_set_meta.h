// The JSON and CSV texts of a data set.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/run/batch/data_set.h"

namespace taxel {

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

}  // namespace taxel
