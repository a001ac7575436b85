// taxel batch: runs a list of jobs on all cores and writes their results.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "app/cli/batch_protocol.h"
#include "app/cli/command_layout.h"
#include "app/cli/policy_dispatch.h"
#include "app/cli/signals.h"
#include "app/version/version.h"
#include "core/base/files.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

struct BatchOptions {
  std::string jobs, out, folder;
  std::optional<int> workers;
  int group = 16, fps = 0;
  bool float64 = false, poses = false, npz = false;
  bool events = false;  ///< prints events for a program instead of texts for a person
  bool remote = false;  ///< the reader of the events runs the groups
  bool worker = false;  ///< runs groups of another process
  bool policy = false;  ///< the reader of the events is the policy of jobs with scenes
};

/// Returns a duration such as "1 h 5 min", "3 min 20 s" or "12 s".
std::string duration_text(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  if (s >= 3600) return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
  return s >= 60 ? fmt::format("{} min {} s", s / 60, s % 60) : fmt::format("{} s", s);
}

std::string progress_text(const BatchProgress& progress) {
  std::string text = fmt::format("{} of {} jobs", progress.finished, progress.jobs);
  if (progress.failed > 0) text += fmt::format(", {} failed", progress.failed);
  if (const double left = seconds_left(progress); left >= 0) text += ", " + duration_text(left) + " left";
  return text;
}

/// Prints the first reasons; failed.jsonl has all.
void warn_of_failures(const BatchReport& report, Console& console) {
  constexpr std::size_t kPrinted = 10;
  const std::vector<FailedJob>& failed = report.result.counts.failed;
  for (std::size_t i = 0; i < std::min(kPrinted, failed.size()); ++i)
    console.warn(fmt::format("line {}, job {}: {}", failed[i].line, failed[i].number, failed[i].error));
  if (failed.size() > kPrinted)
    console.warn(
        fmt::format("{} more jobs failed: {}/failed.jsonl lists all", failed.size() - kPrinted, report.folder));
}

BatchWatch watch_on(Console& console) {
  BatchWatch watch;
  watch.on_progress = [&](const BatchProgress& progress) {
    const auto jobs = static_cast<double>(std::max<std::size_t>(1, progress.jobs));
    console.progress(std::min(0.99, static_cast<double>(progress.finished) / jobs), progress_text(progress));
  };
  watch.on_writing = [&](double fraction) {
    console.progress(std::min(0.99, fraction), "writing the lists of episodes");
  };
  watch.on_note = [&](const std::string& note) { console.warn(note); };
  watch.is_stopped = [] { return received_signal() != 0; };
  return watch;
}

BatchWatch watch_on(BatchEvents& events) {
  BatchWatch watch;
  watch.on_progress = [&events, shown = std::size_t{0}](const BatchProgress& progress) mutable {
    if (progress.finished == shown) return;
    shown = progress.finished;
    events.progress(progress);
  };
  watch.on_writing = [&](double fraction) { events.writing(fraction); };
  watch.on_note = [&](const std::string& note) { events.note(note); };
  watch.is_stopped = [] { return received_signal() != 0; };
  return watch;
}

std::string program_versions() {
  const Versions v = versions();
  return fmt::format("taxel {}, commit {}, MuJoCo {}", v.taxel, v.commit, v.mujoco);
}

BatchSettings settings_of(const BatchOptions& options) {
  BatchSettings settings;
  settings.folder = options.out;
  settings.format = {options.float64, options.poses, options.group, options.fps};
  settings.program = program_versions();
  settings.workers = options.workers.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  settings.npz = options.npz;
  return settings;
}

JobList read_list(const BatchOptions& options, JobSources& sources, Console& console) {
  JobList list = options.folder.empty()
                     ? read_job_list(options.jobs, sources)
                     : parse_job_list(read_file(options.jobs), options.jobs, fs::absolute(options.folder), sources);
  for (const BrokenLine& broken : list.broken)
    console.warn(fmt::format("{}: line {}: {}", options.jobs, broken.line, broken.message));
  for (const std::string& repeat : list.repeats) console.note(options.jobs + ": " + repeat);
  if (list.jobs.empty() && list.broken.empty()) throw Error(options.jobs, "has no job");
  if (list.jobs.empty())
    throw Error(options.jobs, fmt::format("has no job that can run: line {}: {}", list.broken.front().line,
                                          list.broken.front().message));
  return list;
}

/// Runs a list, here or by the reader of the events.
BatchResult run_list(const JobList& list, JobSources& sources, const BatchOptions& options, BatchEvents& events,
                     Console& console) {
  BatchSettings settings = settings_of(options);
  if (!options.events) return run_batch(list, sources, settings, watch_on(console));
  events.program(settings.program);
  std::optional<PolicyDispatch> policy;
  if (options.policy) {
    policy.emplace(events);
    settings.policy = [&](const Job& job, const EpisodeScene& scene, const Episode& row) {
      return policy->act(job, scene, row);
    };
  }
  std::optional<GroupDispatch> dispatch;
  if (options.remote) {
    dispatch.emplace(list, settings.format, sources, events);
    settings.run_group = [&](const JobGroup& group, const JobWatch& watch) { return dispatch->run(group, watch); };
  }
  return run_batch(list, sources, settings, watch_on(events));
}

/// Throws Error for options that do not go with the list.
void check_list(const BatchOptions& options, const JobList& list) {
  if (list.of_scenes && options.remote)
    throw Error("batch", "--remote", "runs scenarios alone: scenes and their files do not travel to another process");
  if (list.of_scenes && options.fps > 0)
    throw Error("batch", "--fps", "is for scenarios: give the scenes a /scene/record_interval");
  for (const Job& job : list.jobs)
    if (job.scene && !job.scene->policy.empty() && !options.policy)
      throw Error(
          options.jobs, fmt::format("line {}: /scene/policy", job.line),
          fmt::format("\"{}\" is a function of Python: call taxel.batch(jobs, out, policy=...)", job.scene->policy));
  if (options.fps == 0) check_rates(list, options.jobs);
}

void check_options(const BatchOptions& options) {
  if (options.jobs.empty() != options.worker)
    throw Error("batch", "jobs", options.worker ? "is not read with --worker" : "is required: name a list of jobs");
  if (options.out.empty() != options.worker)
    throw Error("batch", "--out", options.worker ? "is not written with --worker" : "is required: name a folder");
}

int run_batch_command(const BatchOptions& options, Console& console) {
  const auto start = std::chrono::steady_clock::now();
  check_options(options);
  BatchEvents events(console);
  if (options.worker) return run_groups_of_stdin(program_versions(), events);
  SceneChecker scenes;
  JobSources sources([&] { return default_source(); }, [&](const SceneJob& scene) { return scenes.check(scene); });
  const JobList list = read_list(options, sources, console);
  check_list(options, list);
  const FinishOnSignal finish;
  const BatchResult result = run_list(list, sources, options, events, console);
  console.progress(1);
  if (result.is_stopped) {
    console.warn(fmt::format("ended by {} after {} of {} jobs: the same command continues",
                             name_of_signal(received_signal()), result.finished, list.jobs.size()));
    return FinishOnSignal::exit_status(kDone);
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const BatchReport report{list, result, options.out, wall};
  warn_of_failures(report, console);
  options.events ? events.result(report) : print_report(console, report);
  const bool is_all_done = report.failed() == 0 && list.broken.empty();
  return FinishOnSignal::exit_status(is_all_done ? kDone : kProblemsFound);
}

void add_options_for_programs(OptionList& list, BatchOptions& options) {
  list.add("--events", &options.events,
           "Print progress, notes and the result as lines of JSON, for programs (docs/many_runs.md)");
  list.add("--remote", &options.remote,
           "Run no group: print each as an event, and read its result from stdin; --workers is the number of groups "
           "that are out at the same time",
           {.needs = {"--events"}, .excludes = {"--npz"}});
  list.add("--policy", &options.policy,
           "Print the observations of jobs that name a policy as events, and read their controls from stdin",
           {.needs = {"--events"}, .excludes = {"--remote"}});
  list.add(
      "--worker", &options.worker,
      "Run groups of another process's --remote, from stdin to stdout, until stdin ends; without a list and --out");
}

}  // namespace

Run add_batch(OptionList& list) {
  const auto options = std::make_shared<BatchOptions>();
  list.add("jobs", &options->jobs,
           "List of jobs, one JSON object on a line (docs/many_runs.md); relative file names in it are relative to its "
           "folder",
           {.unit = "FILE"});
  list.add("--out", &options->out,
           "Folder of the results: NumPy archives and lists of JSON, which python -m taxel.data_set makes a LeRobot "
           "data set "
           "of. If a batch was killed, the same command continues it",
           {.unit = "DIR"});
  list.add("--workers", &options->workers, "Number of jobs that run at the same time (default: the number of cores)",
           {.unit = "N", .check = in_range(1, 4096)});
  list.add("--float64", &options->float64, "Write numbers with 64 bits, as `taxel play` does, instead of 32");
  list.add("--poses", &options->poses,
           "Also the poses of the sensor (observation.sensor_pose) and of the mocap body that leads it (action)");
  list.add("--npz", &options->npz, "Also runs/ID.npz for each job, as `taxel play` writes readings.npz");
  list.add(
      "--fps", &options->fps,
      "Resample all episodes to N rows a second, at even intervals; without it a list of different rates is refused",
      {.unit = "N", .check = in_range(1, 1000000)});
  list.add("--group", &options->group, "Largest number of jobs whose results are written at a time",
           {.unit = "N", .check = in_range(1, 4096), .default_text = "16"});
  list.add("--folder", &options->folder,
           "Folder in which relative file names of the list begin (default: the folder of the list)", {.unit = "DIR"});
  add_options_for_programs(list, *options);
  return [options](Console& console) { return run_batch_command(*options, console); };
}

}  // namespace taxel::cli
