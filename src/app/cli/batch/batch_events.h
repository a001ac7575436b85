// The events of a batch for programs: one JSON object on a line of stdout (docs/many_runs.md).
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "app/cli/console.h"
#include "app/cli/report_writer.h"
#include "core/sim/batch/run_batch.h"

namespace taxel::cli {

struct BatchReport {
  const JobList& list;
  const BatchResult& result;
  std::string folder;
  double wall = 0;  ///< wall time of this run [s]

  [[nodiscard]] std::size_t failed() const { return result.counts.failed.size(); }

  void visit(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
};

/// Safe to use from several threads. All functions throw Error if stdout cannot be written.
class BatchEvents {
 public:
  explicit BatchEvents(Console& console) : console_(console) {}

  void program(const std::string& versions);
  void progress(const BatchProgress& progress);
  void writing(double fraction);
  void note(const std::string& message);
  void result(const BatchReport& report);
  /// Gives a group of jobs to the reader. `package` is the text of package_to_json().
  void group(const std::string& package);
  /// A worker has ended one more job of its group.
  void job_ended();
  /// A worker has finished a group: the bytes of the shard follow the line.
  void shard(const std::string& group, std::string_view bytes);

 private:
  template <class Write>
  void send(const char* event, const Write& write, std::string_view bytes = {});

  Console& console_;
  std::mutex mutex_;
};

}  // namespace taxel::cli
