// Runs jobs of a batch: groups of jobs that share a compiled sensor.
#pragma once

#include <functional>
#include <future>
#include <list>
#include <mutex>
#include <span>
#include <string>

#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/shard.h"
#include "core/run/recording/recording.h"

namespace taxel {

/// Exception that leaves a group because the batch is to end.
struct BatchStopped {};

/// What happens around the jobs of a group. Each function may be empty, and is called on the thread of the group.
struct JobWatch {
  std::function<bool()> is_stopped;                                              ///< asked before each step
  std::function<void(const Job& job, const Recording& recording)> on_recording;  ///< a run with its recording
  std::function<void(const Job& job, const std::string& error)> on_end;          ///< `error` is empty without a failure
};

/// Compiles sensors and runs jobs with them. Safe to use from several threads. The compiled sensors of the latest
/// layouts are kept for later groups.
class JobRunner {
 public:
  /// `sources` must outlive the object.
  explicit JobRunner(JobSources& sources) : sources_(sources) {}

  /// Runs jobs of one layout one after the other on one processor core. A job that fails, or whose layout cannot be
  /// compiled, has its reason in the result, and the others go on; so does a job that has an error already. The result
  /// depends on the jobs alone: not on earlier groups, on other threads, or on the number of cores. Throws
  /// BatchStopped, and the errors of `watch`.
  GroupResult run(const std::string& group, std::span<const Job* const> jobs, const BatchFormat& format,
                  const JobWatch& watch);

 private:
  /// A compiled layout, and its text for the data set.
  struct CompiledLayout {
    SensorModelPtr model;
    std::string json;
  };
  using Model = std::shared_future<CompiledLayout>;
  Model model_of(const Job& job);
  void run_job(const Job& job, const BatchFormat& format, const JobWatch& watch, GroupResult& result);
  Recording record(const Job& job, const SensorModelPtr& model, const JobWatch& watch);

  static constexpr std::size_t kKeptModels = 8;

  JobSources& sources_;
  SensorCache cache_;
  std::mutex models_mutex_;
  std::list<std::pair<std::string, Model>> models_;  // by layout key, the latest first
  std::mutex compiler_mutex_;                        // MuJoCo's compiler must not run twice at the same time
};

}  // namespace taxel
