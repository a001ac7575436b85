// The index of a finished batch: which rows of which shard an episode has, its job, and the jobs without an episode.
// `taxel.data_set` (Python) makes a data set for learners of it.
//
//   batch.json      program, format of the numbers, and counts; written last, so that a folder with it is complete
//   episodes.jsonl  a line for each episode: its rows, its job and a summary
//   layouts.jsonl   a line for each layout: its text, and order and unit of its taxels
//   scenes.jsonl    instead of layouts.jsonl: a line for each scene, with its sensors, joints and actions
//   failed.jsonl    a line for each job or line of the list without an episode, and the reason
//   summary.csv     a line for each episode with its changed parameters
//   meshes/         meshes of the layouts, without those of scenes
//   shards/         numbers of the episodes (shard.h)
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/document/batch/job.h"
#include "core/run/batch/shard.h"

namespace taxel {

/// The parts of a batch whose index is to be written.
struct BatchPlan {
  const JobList& list;
  const std::vector<JobGroup>& groups;
  std::filesystem::path folder;  ///< folder of the batch, with the shards
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
  bool operator==(const FailedJob&) const = default;
};

struct BatchCounts {
  std::int64_t episodes = 0, frames = 0;
  std::vector<FailedJob> failed;  ///< in the order of the list
};

/// An episode: a job with rows.
struct EpisodeEntry {
  std::int64_t index = 0, rows = 0;
  std::string shard;           ///< path below the folder of the batch
  std::int64_t first_row = 0;  ///< first row in the shard
  std::size_t layout = 0;      ///< index of BatchIndex::layouts, or of the scenes
  std::string task;
  int line = 0;             ///< line in the list of jobs
  std::int64_t number = 0;  ///< Job::number
  std::uint64_t seed = 0;   ///< Job::seed
  std::string job;          ///< Job::id
  std::vector<JobChange> changes;
  std::string scenario;  ///< JSON text, with which the episode can be played again
  std::string scene;     ///< JSON text of the scene that was run instead; empty for a scenario
  EpisodeSummary summary;
  bool operator==(const EpisodeEntry&) const = default;
};

/// The index of a batch.
struct BatchIndex {
  std::string program;  ///< versions of the program and of MuJoCo
  int bits = 32;        ///< bits of the numbers of the rows: 32 or 64
  std::vector<EpisodeEntry> episodes;
  std::vector<EpisodeSensor> layouts;
  std::vector<FailedJob> failed;
  std::vector<BrokenLine> broken;  ///< lines of the list that gave no jobs
};

/// Throws Error naming `file` unless a shard has the jobs of its group.
void check_jobs(const JobList& list, const JobGroup& group, const ShardHead& head, const std::string& file);

/// Writes the index of finished groups into an empty folder. Memory does not grow with the number of rows. Equal shards
/// give equal bytes. Calls on_progress(fraction), which may throw. Throws Error if a shard cannot be read or has other
/// jobs, or a file cannot be written.
BatchCounts write_batch_index(const std::filesystem::path& folder, const BatchPlan& plan,
                              const std::function<void(double)>& on_progress);

/// Name of the file that a finished batch has.
inline constexpr const char* kBatchFile = "batch.json";

/// The texts of the files of an index.
struct BatchTexts {
  std::string batch, episodes, layouts, failed;  ///< `failed` may be empty
};

/// Parses the texts. `folder` is the batch's in messages. Throws Error naming file, line and JSON pointer.
BatchIndex parse_batch_index(const BatchTexts& texts, const std::filesystem::path& folder);

/// Reads the index of a batch. Throws Error naming the file: it is missing, damaged, of scenes, or of another program
/// or a newer version. The message says how to mend the batch.
BatchIndex read_batch_index(const std::filesystem::path& folder);

// The lines of the files, without line breaks.

std::string episode_to_json(const EpisodeEntry& episode);
std::string layout_entry_to_json(const EpisodeSensor& layout);
std::string scene_entry_to_json(const EpisodeScene& scene);
std::string failed_to_jsonl(const std::vector<FailedJob>& failed, const std::vector<BrokenLine>& broken);
std::string batch_to_json(const BatchPlan& plan, const BatchCounts& counts);

/// Returns the number in a JSON text, or nothing if the text is not one number.
std::optional<double> number_of_json(const std::string& text);

}  // namespace taxel
