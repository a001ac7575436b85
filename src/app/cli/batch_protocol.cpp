#include "app/cli/batch_protocol.h"

#include <fmt/format.h>

#include <chrono>
#include <map>

#include "app/cli/command_layout.h"
#include "app/cli/command_line.h"
#include "core/base/os/process.h"
#include "core/run/batch/shard.h"
#include "core/sim/batch/job_package.h"

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
  if (result.was_complete) return fmt::format("{}: the batch is complete already\n", folder);
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

void BatchEvents::observation(const Job& job, const EpisodeScene& scene, const Episode& observation) {
  send("observation", [&](ReportWriter& w) {
    w("job", job.id);
    w("policy", job.scene->policy);
    w("seed", job.seed);
    w("actions", scene.action);
    w.object("row", [&](ReportWriter& row) {
      for (const EpisodeColumn& column : observation.columns)
        column.is_list ? row(column.name, column.values) : row(column.name, column.values.front());
    });
  });
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

namespace {

using Input = os::StandardInput;

/// Throws Error unless the bytes are the shard of the package's jobs. Returns the description of the shard.
ShardHead checked_head(const std::string& bytes, const JobPackage& package) {
  const Shard shard(bytes, "the result of group " + package.group);
  shard.check();
  const ShardHead& head = shard.head();
  bool is_same = head.group == package.group && head.outcomes.size() == package.jobs.size();
  for (std::size_t k = 0; is_same && k < package.jobs.size(); ++k) is_same = head.outcomes[k].id == package.jobs[k].id;
  if (!is_same) throw Error("the result of group " + package.group, "has other jobs than the group");
  return head;
}

}  // namespace

GroupDispatch::GroupDispatch(const JobList& list, const BatchFormat& format, JobSources& sources, BatchEvents& events)
    : list_(list), format_(format), sources_(sources), events_(events) {
  reader_ = std::jthread([this](const std::stop_token& stop) {
    Input input;
    std::string failure;
    try {
      Input::Result result = Input::Result::waiting;
      while (!stop.stop_requested() && result != Input::Result::ended) result = read_reply(input, stop);
      failure = "stdin has ended: the program that runs the groups has stopped";
    } catch (const Error& e) {
      failure = fmt::format("stdin: {}", e.what());
    }
    const std::scoped_lock lock(mutex_);
    failure_ = failure;
    answered_.notify_all();
  });
}

GroupDispatch::~GroupDispatch() = default;

Input::Result GroupDispatch::read_reply(Input& input, const std::stop_token& stop) {
  std::string line;
  if (const Input::Result result = input.take_line(line); result != Input::Result::done) return result;
  const GroupReply reply = parse_group_reply(line);
  Answer answer{{}, reply.error};
  while (answer.error.empty() && answer.bytes.empty() && !stop.stop_requested())
    if (input.take_bytes(answer.bytes, reply.bytes) == Input::Result::ended) return Input::Result::ended;
  const std::scoped_lock lock(mutex_);
  if (!finished_.contains(reply.group)) answers_.try_emplace(reply.group, std::move(answer));
  answered_.notify_all();
  return Input::Result::done;
}

GroupDispatch::Answer GroupDispatch::wait_for(const std::string& group, const JobWatch& watch) {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (auto answer = answers_.extract(group)) {
      finished_.insert(group);
      return std::move(answer.mapped());
    }
    if (!failure_.empty()) throw Error(failure_);
    if (watch.is_stopped && watch.is_stopped()) throw BatchStopped();
    answered_.wait_for(lock, std::chrono::milliseconds(100));
  }
}

std::string GroupDispatch::run(const JobGroup& group, const JobWatch& watch) {
  const JobPackage package = pack_group(list_, group, format_, sources_);
  events_.group(package_to_json(package));
  Answer answer = wait_for(group.id, watch);
  if (!answer.error.empty()) answer.bytes = failed_shard(package, answer.error);
  const ShardHead head = checked_head(answer.bytes, package);
  for (std::size_t k = 0; k < package.jobs.size(); ++k)
    if (watch.on_end) watch.on_end(package.jobs[k], head.outcomes[k].error);
  return std::move(answer.bytes);
}

int run_groups_of_stdin(const std::string& program, BatchEvents& events) {
  using Result = os::StandardInput::Result;
  JobSources sources([] { return default_source(); });
  JobRunner runner(sources);
  JobWatch watch;
  watch.on_end = [&](const Job&, const std::string&) { events.job_ended(); };
  events.program(program);
  os::StandardInput input;
  std::string line;
  for (Result result = input.take_line(line); result != Result::ended; result = input.take_line(line)) {
    if (result == Result::waiting) continue;
    const JobPackage package = parse_package(line);
    events.shard(package.group, run_package(package, sources, runner, watch));
  }
  return kDone;
}

}  // namespace taxel::cli
