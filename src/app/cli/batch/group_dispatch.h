// Groups of a batch that another program runs: it reads them from stdout and writes their results to stdin.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <thread>

#include "app/cli/batch/batch_events.h"
#include "app/cli/batch/group_reply.h"
#include "core/base/os/standard_input.h"
#include "core/document/batch/job_sources.h"
#include "core/sim/batch/job_package.h"

namespace taxel::cli {

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

}  // namespace taxel::cli
