#include "app/cli/batch/batch_report.h"

#include <fmt/format.h>

#include <map>

namespace taxel::cli {
namespace {

/// Jobs of a line of the list in the summary table.
struct LineCounts {
  std::size_t jobs = 0, failed = 0;
  std::string task;
};

}  // namespace

void BatchReport::visit(ReportWriter& w) const {
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

}  // namespace taxel::cli
