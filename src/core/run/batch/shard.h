// The results of one group of jobs as a NumPy archive: an array for each column with the rows of all episodes, and
// head.json, which describes the jobs. A shard is complete in itself, so that a killed batch loses no finished group.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/archive/npz.h"
#include "core/run/batch/episode.h"

namespace taxel {

/// The result of one job, without its rows.
struct JobOutcome {
  std::string id;         ///< Job::id
  std::int64_t rows = 0;  ///< 0 if the job failed
  EpisodeSummary summary;
  std::string error;  ///< reason of the failure; empty if the job has rows
  bool operator==(const JobOutcome&) const = default;
};

/// A column of a shard: an array of shape (rows, width), or (rows) if it is no list.
struct ShardColumn {
  std::string name;
  std::size_t width = 1;
  bool is_list = false;
  bool operator==(const ShardColumn&) const = default;
};

/// The description of a shard.
struct ShardHead {
  std::string group;                    ///< JobGroup::id
  std::vector<JobOutcome> outcomes;     ///< in the order of the group
  std::optional<EpisodeSensor> sensor;  ///< empty if all jobs failed, and for scenes
  std::optional<EpisodeScene> scene;    ///< empty if all jobs failed, and for scenarios
  std::vector<ShardColumn> columns;     ///< empty if all jobs failed
  bool operator==(const ShardHead&) const = default;
};

/// The results of a group in memory.
struct GroupResult {
  ShardHead head;                 ///< without the columns
  std::vector<Episode> episodes;  ///< episodes of the outcomes without an error, in their order
};

/// Largest size of a shard, and bytes to which its arrays may unpack: readings of a large skin are nearly all 0 and
/// pack well. The recordings of a whole group were in memory when it was written.
inline constexpr std::uint64_t kMostShardBytes = std::uint64_t{16} << 30U;

/// Returns the name of a group's shard, below the folder of the batch.
std::string shard_name(const std::string& group);

/// Returns the bytes of a shard. Equal results give equal bytes.
std::string shard_bytes(const GroupResult& result, const BatchFormat& format);

/// A shard that is read.
class Shard {
 public:
  /// Reads the description. Throws Error naming the file if it cannot be read or is not a shard.
  explicit Shard(const std::filesystem::path& path);
  /// The same of bytes in memory; `name` names them in messages.
  Shard(std::string bytes, std::string name);

  [[nodiscard]] const ShardHead& head() const { return head_; }
  [[nodiscard]] const std::string& file() const { return arrays_.file(); }
  /// Returns the values of `count` rows of a column from row `first`. Throws Error naming file and column if there is
  /// no such column, or its array is damaged or lacks these rows.
  [[nodiscard]] EpisodeColumn rows(const std::string& column, std::int64_t first, std::int64_t count) const;
  /// Reads all arrays. Throws Error naming one that is damaged.
  void check() const;

 private:
  explicit Shard(ZipArchive archive);
  [[nodiscard]] std::vector<double> values(const ShardColumn& column) const;

  ShardHead head_;
  std::size_t rows_ = 0;
  NpzReader arrays_;
};

std::string shard_head_to_json(const ShardHead& head);
/// Parses shard_head_to_json(). Throws Error(file, JSON pointer, ...).
ShardHead parse_shard_head(const std::string& text, const std::string& file);

}  // namespace taxel
