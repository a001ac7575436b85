#include "app/cli/batch/batch_events.h"

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

template <class Write>
void BatchEvents::send(const char* event, const Write& write, std::string_view bytes) {
  ReportWriter writer;
  writer("event", event);
  write(writer);
  const std::string line = writer.text(JsonStyle::one_line);
  const std::scoped_lock lock(mutex_);
  console_.result(line);
  if (!bytes.empty()) console_.result(bytes);
}

void BatchEvents::program(const std::string& versions) {
  send("program", [&](ReportWriter& w) { w("program", versions); });
}

void BatchEvents::progress(const BatchProgress& progress) {
  send("progress", [&](ReportWriter& w) {
    w("jobs", progress.jobs);
    w("finished", progress.finished);
    w("failed", progress.failed);
    w("resumed", progress.resumed);
    w("seconds", progress.seconds);
    const double left = seconds_left(progress);
    left >= 0 ? w("seconds_left", left) : w("seconds_left", nullptr);
  });
}

void BatchEvents::writing(double fraction) {
  send("writing", [&](ReportWriter& w) { w("fraction", fraction); });
}

void BatchEvents::note(const std::string& message) {
  send("note", [&](ReportWriter& w) { w("message", message); });
}

void BatchEvents::result(const BatchReport& report) {
  send("result", [&](ReportWriter& w) { report.visit(w); });
}

void BatchEvents::group(const std::string& package) {
  send("group", [&](ReportWriter& w) { w.object("package", [&](ReportWriter& one) { one.keys_of(package); }); });
}

void BatchEvents::job_ended() {
  send("job", [](ReportWriter&) {});
}

void BatchEvents::shard(const std::string& group, std::string_view bytes) {
  send(
      "shard",
      [&](ReportWriter& w) {
        w("group", group);
        w("bytes", bytes.size());
      },
      bytes);
}

}  // namespace taxel::cli
