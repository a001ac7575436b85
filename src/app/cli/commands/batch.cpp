// taxel batch: runs a list of jobs on all cores and writes a data set.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <thread>

#include "app/cli/default_layout.h"
#include "app/cli/report_writer.h"
#include "app/cli/signals.h"
#include "app/version/version.h"
#include "core/document/batch/job_list.h"
#include "core/sim/batch/run_batch.h"

namespace taxel::cli {
namespace {

struct BatchOptions {
  std::string jobs, out;
  std::optional<int> workers;
  int group = 16;
  bool float64 = false, poses = false, npz = false;
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

struct BatchReport {
  const JobList& list;
  const BatchResult& result;
  std::string folder;
  double wall = 0;  ///< wall time of this run [s]

  [[nodiscard]] std::size_t failed() const { return result.counts.failed.size(); }

  void visit(ReportWriter& w) const {
    w("jobs", list.jobs.size());
    w("episodes", result.counts.episodes);
    w("frames", result.counts.frames);
    w("resumed", result.resumed);
    w("was_complete", result.was_complete);
    w("folder", folder);
    w("wall_seconds", wall);
    w.list("failed", result.counts.failed, [](ReportWriter& one, const FailedJob& job) {
      one("line", job.line);
      one("number", job.number);
      one("job", job.id);
      one("error", job.error);
    });
    w.list("broken_lines", list.broken, [](ReportWriter& one, const BrokenLine& broken) {
      one("line", broken.line);
      one("error", broken.message);
    });
  }
  [[nodiscard]] std::string text() const;
};

/// Jobs of a line of the list in the summary table.
struct LineCounts {
  std::size_t jobs = 0, failed = 0;
  std::string task;
};

std::string BatchReport::text() const {
  if (result.was_complete) return fmt::format("{}: the data set is complete already\n", folder);
  std::map<int, LineCounts> lines;
  for (const Job& job : list.jobs) {
    LineCounts& line = lines[job.line];
    ++line.jobs;
    if (!job.task.empty()) line.task = job.task;
  }
  for (const FailedJob& job : result.counts.failed) ++lines[job.line].failed;
  std::string text = fmt::format("{:>6} {:>8} {:>8}  {}\n", "line", "episodes", "failed", "task");
  for (const auto& [number, line] : lines)
    text += fmt::format("{:>6} {:>8} {:>8}  {}\n", number, line.jobs - line.failed, line.failed, line.task);
  const std::size_t made = result.finished - result.resumed;
  text += fmt::format("{} episodes of {} jobs, {} failed, {} frames", result.counts.episodes, list.jobs.size(),
                      failed(), result.counts.frames);
  if (result.resumed > 0) text += fmt::format("; {} jobs were finished before", result.resumed);
  text += fmt::format("\n{:.2f} s", wall);
  if (made > 0) text += fmt::format(", {:.1f} ms a job", 1000 * wall / static_cast<double>(made));
  return text + fmt::format("\nwrote {}\n", folder);
}

/// Prints the first reasons; meta/failed.jsonl has all.
void warn_of_failures(const BatchReport& report, Console& console) {
  constexpr std::size_t kPrinted = 10;
  const std::vector<FailedJob>& failed = report.result.counts.failed;
  for (std::size_t i = 0; i < std::min(kPrinted, failed.size()); ++i)
    console.warn(fmt::format("line {}, job {}: {}", failed[i].line, failed[i].number, failed[i].error));
  if (failed.size() > kPrinted)
    console.warn(
        fmt::format("{} more jobs failed: {}/meta/failed.jsonl lists all", failed.size() - kPrinted, report.folder));
}

BatchWatch watch_on(Console& console) {
  BatchWatch watch;
  watch.on_progress = [&](const BatchProgress& progress) {
    const auto jobs = static_cast<double>(std::max<std::size_t>(1, progress.jobs));
    console.progress(std::min(0.99, static_cast<double>(progress.finished) / jobs), progress_text(progress));
  };
  watch.on_writing = [&](double fraction) { console.progress(std::min(0.99, fraction), "writing the data set"); };
  watch.on_note = [&](const std::string& note) { console.warn(note); };
  watch.is_stopped = [] { return received_signal() != 0; };
  return watch;
}

BatchSettings settings_of(const BatchOptions& options) {
  const Versions v = versions();
  BatchSettings settings;
  settings.folder = options.out;
  settings.format = {options.float64, options.poses, options.group};
  settings.program = fmt::format("taxel {}, commit {}, MuJoCo {}", v.taxel, v.commit, v.mujoco);
  settings.workers = options.workers.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  settings.npz = options.npz;
  return settings;
}

int run_batch_command(const BatchOptions& options, Console& console) {
  const auto start = std::chrono::steady_clock::now();
  JobSources sources([&] { return default_source(); });
  const JobList list = read_job_list(options.jobs, sources);
  for (const BrokenLine& broken : list.broken)
    console.warn(fmt::format("{}: line {}: {}", options.jobs, broken.line, broken.message));
  for (const std::string& repeat : list.repeats) console.note(options.jobs + ": " + repeat);
  if (list.jobs.empty()) throw Error(options.jobs, "has no job that can run");
  const FinishOnSignal finish;
  const BatchResult result = run_batch(list, sources, settings_of(options), watch_on(console));
  console.progress(1);
  if (result.is_stopped) {
    console.warn(fmt::format("ended by {} after {} of {} jobs: the same command continues",
                             name_of_signal(received_signal()), result.finished, list.jobs.size()));
    return FinishOnSignal::exit_status(kDone);
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const BatchReport report{list, result, options.out, wall};
  warn_of_failures(report, console);
  print_report(console, report);
  const bool is_all_done = report.failed() == 0 && list.broken.empty();
  return FinishOnSignal::exit_status(is_all_done ? kDone : kProblemsFound);
}

}  // namespace

Run add_batch(OptionList& list) {
  const auto options = std::make_shared<BatchOptions>();
  list.add("jobs", &options->jobs,
           "List of jobs, one JSON object on a line (docs/many_runs.md); relative file names in it are relative to its "
           "folder",
           {.unit = "FILE", .is_required = true});
  list.add(
      "--out", &options->out,
      "Folder of the data set (Parquet files in the shape of LeRobot's version 3). If a batch was killed, the same "
      "command continues it",
      {.unit = "DIR", .is_required = true});
  list.add("--workers", &options->workers, "Number of jobs that run at the same time (default: the number of cores)",
           {.unit = "N", .check = in_range(1, 1024)});
  list.add("--float64", &options->float64, "Write numbers with 64 bits, as `taxel play` does, instead of 32");
  list.add("--poses", &options->poses,
           "Also the poses of the sensor (observation.sensor_pose) and of the mocap body that leads it (action)");
  list.add("--npz", &options->npz, "Also runs/ID.npz for each job, as `taxel play` writes readings.npz");
  list.add("--group", &options->group, "Largest number of jobs whose results are written at a time",
           {.unit = "N", .check = in_range(1, 4096), .default_text = "16"});
  return [options](Console& console) { return run_batch_command(*options, console); };
}

}  // namespace taxel::cli
