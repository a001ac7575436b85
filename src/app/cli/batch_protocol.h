// The lines of JSON between a batch and another program (docs/many_runs.md): the events of the batch on stdout, the
// groups of jobs that the other program runs with its replies on stdin, and the worker that runs them.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "app/cli/console.h"
#include "app/cli/report_writer.h"
#include "core/base/os/process.h"
#include "core/document/batch/job_sources.h"
#include "core/sim/batch/job_package.h"
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

/// Writes the events of a batch, one JSON object on a line. Safe to use from several threads. All functions throw Error
/// if stdout cannot be written.
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
  /// Gives the values of a row to the policy of a job.
  void observation(const Job& job, const EpisodeScene& scene, const Episode& observation);
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

/// The answer of another program to a group that it was given to run: {"group": ID, "bytes": N} with the N bytes of a
/// shard behind the line, or {"group": ID, "error": REASON}.
struct GroupReply {
  std::string group;
  std::size_t bytes = 0;  ///< size of the shard that follows
  std::string error;      ///< reason why all jobs of the group fail; empty with a shard
};

/// Throws Error("", JSON pointer, ...) if the line is not a reply.
GroupReply parse_group_reply(const std::string& line);

/// Groups of a batch that another program runs: it reads them from stdout and writes their results to stdin.
class GroupDispatch {
 public:
  /// Starts to read stdin. All arguments must outlive the object.
  GroupDispatch(const JobList& list, const BatchFormat& format, JobSources& sources, BatchEvents& events);
  ~GroupDispatch();
  GroupDispatch(const GroupDispatch&) = delete;
  GroupDispatch& operator=(const GroupDispatch&) = delete;

  /// A RunGroup. The first result of a group counts, and later ones are ignored. Throws Error if a result is damaged or
  /// of other jobs, or if stdin has ended.
  std::string run(const JobGroup& group, const JobWatch& watch);

 private:
  struct Answer {
    std::string bytes, error;
  };
  os::StandardInput::Result read_reply(os::StandardInput& input, const std::stop_token& stop);
  Answer wait_for(const std::string& group, const JobWatch& watch);

  const JobList& list_;
  BatchFormat format_;
  JobSources& sources_;
  BatchEvents& events_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable answered_;
  std::set<std::string> finished_;  // groups whose answers were taken
  std::map<std::string, Answer> answers_;
  std::string failure_;  // reason why no more answers come; empty while they may
  std::jthread reader_;
};

/// A worker, which keeps compiled layouts: runs each line of stdin, a package of jobs (core/sim/batch/job_package.h) in
/// which `files` names a copy of each file, and answers with the bytes of the shard. Returns the exit status at the end
/// of stdin. Throws Error for a line that is not a package, and for a copy that is missing.
int run_groups_of_stdin(const std::string& program, BatchEvents& events);

}  // namespace taxel::cli
