// The description of a data set of `taxel batch`: the program that wrote it, and the jobs without an episode.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/document/batch/job.h"
#include "core/run/batch/data_set.h"

namespace taxel {

/// Files of every data set, below its folder.
inline constexpr const char* kDataSetInfoFile = "meta/info.json";
inline constexpr const char* kDataSetHeadFile = "meta/taxel.json";
inline constexpr const char* kFailedJobsFile = "meta/failed.jsonl";

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
