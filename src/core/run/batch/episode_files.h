// The table of episodes of a data set, and summary.csv.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/run/batch/row_files.h"

namespace taxel {

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

/// Writes a row for each episode, group by group.
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
