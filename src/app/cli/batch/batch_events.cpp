#include "app/cli/batch/batch_events.h"

namespace taxel::cli {

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
