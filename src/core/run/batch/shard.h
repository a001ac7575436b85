// The results of one group of jobs as a Parquet file: one row group with the rows of all episodes, and a description of
// the jobs in the footer. A shard is complete in itself, so that a killed batch loses no finished group.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/run/batch/episode.h"
#include "core/run/parquet/parquet_file.h"

namespace taxel {

/// The result of one job, without its rows.
struct JobOutcome {
  std::string id;         ///< Job::id
  std::int64_t rows = 0;  ///< 0 if the job failed
  EpisodeSummary summary;
  std::string error;  ///< reason of the failure; empty if the job has rows
  bool operator==(const JobOutcome&) const = default;
};

/// The description of a shard.
struct ShardHead {
  std::string group;                           ///< JobGroup::id
  std::vector<JobOutcome> outcomes;            ///< in the order of the group
  std::optional<EpisodeSensor> sensor;         ///< empty if all jobs failed
  std::map<std::string, std::int64_t> widths;  ///< number of values in a row of each column
  bool operator==(const ShardHead&) const = default;
};

/// The results of a group in memory.
struct GroupResult {
  ShardHead head;
  std::vector<Episode> episodes;  ///< episodes of the outcomes without an error, in their order
};

/// Returns the bytes of a shard. Equal results give equal bytes.
std::string shard_bytes(const GroupResult& result, const BatchFormat& format);

/// Returns the description of a shard. Throws Error naming the file if it is not a shard.
ShardHead read_shard_head(const ParquetFile& file);

std::string shard_head_to_json(const ShardHead& head);
/// Parses shard_head_to_json(). Throws Error(file, JSON pointer, ...).
ShardHead parse_shard_head(const std::string& text, const std::string& file);

}  // namespace taxel
