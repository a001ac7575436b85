#include "core/sim/batch/run_batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "core/base/files.h"
#include "core/base/limits.h"
#include "core/base/parallel.h"
#include "core/base/text/message.h"
#include "core/document/scenario/scenario.h"
#include "core/run/batch/batch_folder.h"
#include "core/run/batch/batch_index.h"
#include "core/run/recording/recording_files.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/scene_run.h"
#include "core/sim/simulator.h"

namespace taxel {

JobRunner::Model JobRunner::model_of(const Job& job) {
  std::promise<CompiledLayout> promise;
  Model model;
  {
    const std::scoped_lock lock(models_mutex_);
    const auto found = std::ranges::find(models_, job.layout_key, &std::pair<std::string, Model>::first);
    if (found != models_.end()) {
      models_.splice(models_.begin(), models_, found);
      return models_.front().second;
    }
    model = promise.get_future().share();
    models_.emplace_front(job.layout_key, model);
    if (models_.size() > kKeptModels) models_.pop_back();
  }
  try {
    SensorBuild how;
    how.cache = &cache_;
    const SensorSource source = sources_.changed_source(job.layout, job.changes);
    promise.set_value({build_sensor_model(source, how), JobSources::portable_json(source)});
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return model;
}

Recording JobRunner::record(const Job& job, const SensorModelPtr& model, const JobWatch& watch) {
  std::unique_ptr<Simulator> simulator;
  {
    const std::scoped_lock lock(compiler_mutex_);
    simulator = Simulator::make_scenario(model, job.scenario);
  }
  RunRecorder recorder(*simulator->scene());
  StepView view;
  while (!simulator->finished()) {
    if (watch.is_stopped && watch.is_stopped()) throw BatchStopped();
    simulator->step();
    follow_latest_step(*simulator, recorder, view);
    if (recorder.bytes() > kMaxRecordingBytes)
      throw Error(
          fmt::format("the recording takes more than {} GiB of memory: record fewer rows", kMaxRecordingBytes >> 30U));
  }
  return recorder.take();
}

/// Runs a job, and describes its sensors in the head of the group.
Episode JobRunner::play(const Job& job, const BatchFormat& format, const JobWatch& watch, Recording& recording,
                        ShardHead& head) {
  if (job.scene) {
    SceneResult run = scenes_.run(job, format.poses, watch.is_stopped, watch.policy);
    recording = std::move(run.recording);
    if (!head.scene) head.scene = std::move(run.scene);
    return std::move(run.episode);
  }
  const CompiledLayout layout = model_of(job).get();
  on_this_core([&] { recording = record(job, layout.model, watch); });
  Episode episode = episode_of(recording, format.poses);
  if (format.fps > 0) episode = resampled(episode, format.fps);
  if (!head.sensor) {
    head.sensor = sensor_of(recording);
    head.sensor->layout_key = job.layout_key;
    head.sensor->layout_json = layout.json;
    head.sensor->layout_name = layout.model->layout.name;
  }
  return episode;
}

void JobRunner::run_job(const Job& job, const BatchFormat& format, const JobWatch& watch, GroupResult& result) {
  JobOutcome outcome;
  outcome.id = job.id;
  Recording recording;
  Episode episode;
  try {
    if (!job.error.empty()) throw Error(job.error);
    episode = play(job, format, watch, recording, result.head);
  } catch (const Error& e) {
    outcome.error = job.error.empty() ? shown_message(e) : job.error;
  } catch (const std::bad_alloc&) {
    outcome.error = "there is not enough memory";
  }
  if (outcome.error.empty()) {
    if (watch.on_recording) watch.on_recording(job, recording);
    outcome.rows = episode.rows;
    outcome.summary = episode.summary;
    result.episodes.push_back(std::move(episode));
  }
  if (watch.on_end) watch.on_end(job, outcome.error);
  result.head.outcomes.push_back(std::move(outcome));
}

GroupResult JobRunner::run(const std::string& group, std::span<const Job* const> jobs, const BatchFormat& format,
                           const JobWatch& watch) {
  GroupResult result;
  result.head.group = group;
  for (const Job* job : jobs) run_job(*job, format, watch, result);
  return result;
}

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kRuns = "runs/";

/// Returns the path of the archive with the rows of the job with this id, below the folder of the batch.
std::string run_name(const std::string& job) {
  constexpr std::size_t kDigits = 32;
  return std::string(kRuns) + job.substr(0, kDigits) + ".npz";
}

/// Returns whether the whole shard of a group is on the disk, and the archives of its runs if these are wanted. All
/// arrays are read: a damaged one would be found by the reader of the batch, when no job runs any more.
bool has_results(const BatchFolder& folder, const JobList& list, const JobGroup& group, const BatchSettings& settings) {
  try {
    const Shard shard(folder.root() / shard_name(group.id));
    check_jobs(list, group, shard.head(), shard.file());
    shard.check();
    std::error_code ec;
    return !settings.npz || std::ranges::all_of(shard.head().outcomes, [&](const JobOutcome& job) {
      return !job.error.empty() || fs::exists(folder.root() / run_name(job.id), ec);
    });
  } catch (const Error&) {
    return false;
  }
}

/// The groups of a batch, which workers take one after the other.
class GroupQueue {
 public:
  GroupQueue(const JobList& list, const std::vector<JobGroup>& groups, JobSources& sources,
             const BatchSettings& settings, const BatchFolder& folder, BatchJournal& journal)
      : list_(list), groups_(groups), settings_(settings), folder_(folder), journal_(journal), runner_(sources) {}

  /// Finds the groups that are to run. A shard without an entry in the journal was written just before the process was
  /// killed, and is kept.
  void find_pending(const std::function<void(const std::string&)>& on_note) {
    for (const JobGroup& group : groups_) {
      const bool is_listed = journal_.content().groups.contains(group.id),
                 is_there = has_results(folder_, list_, group, settings_);
      if (is_listed && !is_there) {
        on_note(fmt::format("{}: the results are missing or damaged, so {} jobs run again",
                            (folder_.root() / shard_name(group.id)).string(), group.jobs.size()));
        journal_.forget_group(group.id);
      }
      if (!is_listed && is_there) journal_.add_group(group.id);
      if (is_there) {
        resumed_ += group.jobs.size();
      } else {
        pending_.push_back(&group);
      }
    }
    finished_ = resumed_;
  }

  /// Runs all pending groups and calls on_turn() a few times per second. Throws the first error of a worker, after all
  /// have ended.
  void run(const std::function<void()>& on_turn) {
    std::vector<std::jthread> workers;
    {
      const std::scoped_lock lock(mutex_);
      running_ = settings_.workers;
    }
    for (int i = 0; i < settings_.workers; ++i) workers.emplace_back([this] { work(); });
    std::unique_lock lock(mutex_);
    while (running_ > 0) {
      ended_.wait_for(lock, std::chrono::milliseconds(100));
      lock.unlock();
      on_turn();
      lock.lock();
    }
    if (failure_) std::rethrow_exception(failure_);
  }
  void stop() { is_stopped_ = true; }
  [[nodiscard]] std::size_t resumed() const { return resumed_; }
  [[nodiscard]] std::size_t finished() const { return finished_; }
  [[nodiscard]] std::size_t failed() const { return failed_; }

 private:
  void work() {
    try {
      for (std::size_t i = next_++; i < pending_.size() && !is_stopped_; i = next_++) run_group(*pending_[i]);
    } catch (const BatchStopped&) {
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      is_stopped_ = true;
    }
    const std::scoped_lock lock(mutex_);
    --running_;
    ended_.notify_all();
  }

  void run_group(const JobGroup& group) {
    JobWatch watch;
    watch.is_stopped = [this] { return is_stopped_.load(std::memory_order_relaxed); };
    watch.on_end = [this](const Job&, const std::string& error) {
      ++finished_;
      if (!error.empty()) ++failed_;
    };
    watch.policy = settings_.policy;
    if (settings_.npz)
      watch.on_recording = [this](const Job& job, const Recording& recording) {
        write_file_atomically(folder_.root() / run_name(job.id), recording_to_npz(recording));
      };
    const std::string bytes = settings_.run_group ? settings_.run_group(group, watch) : run_here(group, watch);
    const fs::path shard = folder_.root() / shard_name(group.id);
    make_folder(shard.parent_path());
    write_file_atomically(shard, bytes);
    const std::scoped_lock lock(mutex_);
    journal_.add_group(group.id);
  }

  [[nodiscard]] std::string run_here(const JobGroup& group, const JobWatch& watch) {
    std::vector<const Job*> jobs;
    for (const std::size_t job : group.jobs) jobs.push_back(&list_.jobs[job]);
    return shard_bytes(runner_.run(group.id, jobs, settings_.format, watch), settings_.format);
  }

  const JobList& list_;
  const std::vector<JobGroup>& groups_;
  const BatchSettings& settings_;
  const BatchFolder& folder_;
  BatchJournal& journal_;
  JobRunner runner_;
  std::vector<const JobGroup*> pending_;
  std::size_t resumed_ = 0;
  std::atomic<std::size_t> next_ = 0, finished_ = 0, failed_ = 0;
  std::atomic<bool> is_stopped_ = false;
  std::mutex mutex_;  // guards the members below and journal_
  std::condition_variable ended_;
  int running_ = 0;
  std::exception_ptr failure_;
};

/// Writes the mesh of each layout, so that the layouts of the batch can be used anywhere.
void write_meshes(const fs::path& folder, const BatchPlan& plan, JobSources& sources) {
  std::set<std::string> layouts, names;
  for (const JobGroup& group : plan.groups) {
    const Job& job = plan.list.jobs[group.jobs.front()];
    if (job.scene) continue;
    if (!layouts.insert(job.layout_key).second) continue;
    const MeshFile mesh = sources.mesh_file(job.layout, job.changes);
    if (!names.insert(mesh.name).second) continue;
    make_folder(folder);
    write_file_atomically(folder / mesh.name, mesh.bytes);
  }
}

/// Returns `files` and those of `before` that differ from them.
std::vector<PublishedFile> with_replaced(std::vector<PublishedFile> files, const std::vector<PublishedFile>& before) {
  std::set<std::pair<std::string, std::string>> known;
  for (const PublishedFile& file : files) known.emplace(file.name, file.sha256);
  for (const PublishedFile& old : before)
    if (known.emplace(old.name, old.sha256).second) files.push_back(old);
  return files;
}

/// Writes the index, and records that the batch is complete.
BatchCounts write_and_publish(const BatchPlan& plan, const BatchFolder& folder, BatchJournal& journal,
                              JobSources& sources, const BatchSettings& settings, const BatchWatch& watch) {
  const auto on_progress = [&](double fraction) {
    if (watch.on_writing) watch.on_writing(fraction);
  };
  const fs::path staging = folder.empty_staging();
  BatchCounts counts = write_batch_index(staging, plan, on_progress);
  write_meshes(staging / "meshes", plan, sources);
  const std::vector<PublishedFile> staged = folder.staged_files(), before = journal.content().files;
  std::vector<std::string> names;
  for (const JobGroup& group : plan.groups) names.push_back(shard_name(group.id));
  if (settings.npz)
    for (const Job& job : plan.list.jobs) names.push_back(run_name(job.id));
  std::vector<PublishedFile> files = folder.result_files(names);
  files.insert(files.end(), staged.begin(), staged.end());
  const std::vector<PublishedFile> all = with_replaced(files, before);
  journal.publish(all);
  folder.publish(staged, before);
  if (all.size() > files.size()) journal.publish(files);
  journal.complete();
  folder.clean();
  return counts;
}

/// Returns whether an earlier run has finished the batch, with its runs if these are wanted, and all its files are
/// there. Otherwise groups without their files run again, and the index is written again.
bool is_still_complete(const BatchSettings& settings, const BatchFolder& folder, BatchJournal& journal,
                       const std::function<void(const std::string&)>& on_note) {
  if (!journal.content().is_complete) return false;
  const std::vector<PublishedFile>& files = journal.content().files;
  std::string missing = folder.first_missing(files);
  const auto is_run = [](const PublishedFile& file) { return file.name.starts_with(kRuns); };
  const auto has_episodes = [](const PublishedFile& file) { return file.name == "episodes.jsonl" && file.bytes > 0; };
  if (settings.npz && missing.empty() && std::ranges::any_of(files, has_episodes) &&
      std::ranges::none_of(files, is_run))
    missing = run_name("ID");
  if (missing.empty()) return true;
  on_note(fmt::format("{}: is missing, and is made again", (settings.folder / missing).string()));
  journal.reopen();
  return false;
}

/// Calls work(), and adds to an Error that the batch can be continued.
template <class Work>
void with_remedy(const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    throw Error(e.file(), e.where(), e.message() + "; all finished groups are kept, and the same command continues");
  }
}

}  // namespace

double seconds_left(const BatchProgress& progress) {
  const std::size_t ended = progress.finished - progress.resumed;
  if (ended == 0) return -1;
  return progress.seconds * static_cast<double>(progress.jobs - progress.finished) / static_cast<double>(ended);
}

BatchResult run_batch(const JobList& list, JobSources& sources, const BatchSettings& settings,
                      const BatchWatch& watch) {
  const BatchFolder folder(settings.folder);
  BatchJournal journal(folder.journal(), {list.sha256, settings.program, settings.format});
  BatchResult result;
  const auto on_note = [&](const std::string& note) {
    if (watch.on_note) watch.on_note(note);
  };
  const bool was_finished = journal.content().is_complete;
  if (is_still_complete(settings, folder, journal, on_note)) {
    result.was_complete = true;
    folder.clean();
    return result;
  }
  folder.withdraw(journal.content().files);
  const std::vector<JobGroup> groups = group_jobs(list, static_cast<std::size_t>(settings.format.group_size));
  if (settings.npz) make_folder(folder.root() / kRuns);
  GroupQueue queue(list, groups, sources, settings, folder, journal);
  queue.find_pending(was_finished ? [](const std::string&) {} : std::function<void(const std::string&)>(on_note));
  const auto jobs =
      static_cast<std::size_t>(std::ranges::count_if(list.jobs, [](const Job& j) { return j.error.empty(); }));
  const Clock::time_point start = Clock::now();
  const auto on_turn = [&] {
    if (watch.is_stopped && watch.is_stopped()) queue.stop();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (watch.on_progress) watch.on_progress({jobs, queue.finished(), queue.failed(), queue.resumed(), seconds});
  };
  with_remedy([&] { queue.run(on_turn); });
  result.resumed = queue.resumed();
  result.finished = queue.finished();
  result.is_stopped = watch.is_stopped && watch.is_stopped();
  if (result.is_stopped) return result;
  const BatchPlan plan{list, groups, folder.root(), settings.format, settings.program};
  with_remedy([&] { result.counts = write_and_publish(plan, folder, journal, sources, settings, watch); });
  return result;
}

}  // namespace taxel
