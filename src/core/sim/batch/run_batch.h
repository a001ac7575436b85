// Runs all jobs of a list on several cores and writes their results (docs/many_runs.md). A batch that was killed is
// resumed by running it again: finished groups are not repeated, and its files have the same bytes.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <list>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/batch_index.h"
#include "core/run/batch/shard.h"
#include "core/run/recording/recording.h"
#include "core/sim/batch/batch_stopped.h"
#include "core/sim/batch/scene_jobs.h"

namespace taxel {

/// What happens around the jobs of a group. Each function may be empty, and is called on the thread of the group.
struct JobWatch {
  std::function<bool()> is_stopped;                                              ///< asked before each step
  std::function<void(const Job& job, const Recording& recording)> on_recording;  ///< a run with its recording
  std::function<void(const Job& job, const std::string& error)> on_end;          ///< `error` is empty without a failure
  JobPolicy policy;                                                              ///< sets controls
};

/// Compiles sensors and runs jobs with them. Safe to use from several threads. The compiled sensors of the latest
/// layouts are kept for later groups.
class JobRunner {
 public:
  /// `sources` must outlive the object.
  explicit JobRunner(JobSources& sources) : sources_(sources) {}

  /// Runs jobs of one layout or one scene one after the other on one processor core. A job that fails, or whose layout
  /// cannot be compiled, has its reason in the result, and the others go on; so does a job that has an error already.
  /// The result depends on the jobs alone: not on earlier groups, on other threads, or on the number of cores. Throws
  /// BatchStopped, and the errors of `watch`.
  GroupResult run(const std::string& group, std::span<const Job* const> jobs, const BatchFormat& format,
                  const JobWatch& watch);

 private:
  /// A compiled layout, and its text for the index.
  struct CompiledLayout {
    SensorModelPtr model;
    std::string json;
  };
  using Model = std::shared_future<CompiledLayout>;
  Model model_of(const Job& job);
  void run_job(const Job& job, const BatchFormat& format, const JobWatch& watch, GroupResult& result);
  Episode play(const Job& job, const BatchFormat& format, const JobWatch& watch, Recording& recording, ShardHead& head);
  Recording record(const Job& job, const SensorModelPtr& model, const JobWatch& watch);

  static constexpr std::size_t kKeptModels = 8;

  JobSources& sources_;
  SensorCache cache_;
  std::mutex models_mutex_;
  std::list<std::pair<std::string, Model>> models_;  // by layout key, the latest first
  std::mutex compiler_mutex_;                        // MuJoCo's compiler must not run twice at the same time
  SceneRunner scenes_{compiler_mutex_};
};

/// Runs a group of jobs somewhere else, and returns the bytes of its shard. Called on several threads at a time, as
/// many as BatchSettings::workers. Asks watch.is_stopped() a few times per second. Throws BatchStopped, and Error if
/// nothing can be run any more.
using RunGroup = std::function<std::string(const JobGroup& group, const JobWatch& watch)>;

struct BatchSettings {
  std::filesystem::path folder;  ///< folder of the batch
  BatchFormat format;
  std::string program;  ///< versions of the program and of MuJoCo
  int workers = 1;      ///< number of groups that run at the same time
  bool npz = false;     ///< writes runs/ID.npz for each job as well
  RunGroup run_group;   ///< runs the groups instead of this process; not together with `npz`
  JobPolicy policy;     ///< sets the controls of jobs that name a policy; called on several threads
};

/// The state of a batch that runs.
struct BatchProgress {
  std::size_t jobs = 0;      ///< number of jobs
  std::size_t finished = 0;  ///< jobs that have ended, now or in an earlier run
  std::size_t failed = 0;    ///< jobs that have failed in this run
  std::size_t resumed = 0;   ///< jobs that an earlier run has finished
  double seconds = 0;        ///< wall time of this run
};

/// Returns the expected wall time until the end [s]; negative if no job of this run has ended.
double seconds_left(const BatchProgress& progress);

/// How the caller follows a batch. The functions are called on the caller's thread, a few times per second.
struct BatchWatch {
  std::function<void(const BatchProgress&)> on_progress;
  std::function<void(double fraction)> on_writing;  ///< the index is written
  std::function<void(const std::string&)> on_note;  ///< something that the user should know
  std::function<bool()> is_stopped;                 ///< true to end the batch early
};

struct BatchResult {
  BatchCounts counts;
  std::size_t resumed = 0;    ///< jobs that an earlier run has finished
  bool was_complete = false;  ///< an earlier run has finished the batch
  bool is_stopped = false;    ///< the batch was ended early; its index is not written
  std::size_t finished = 0;   ///< jobs that have ended
};

/// Runs a batch. Its files do not depend on `workers`, nor on how often the batch was interrupted. Throws Error if
/// the folder belongs to something else or another process writes into it, or if a file cannot be written; all finished
/// groups are then kept for the next run.
BatchResult run_batch(const JobList& list, JobSources& sources, const BatchSettings& settings, const BatchWatch& watch);

}  // namespace taxel
