// The policy of jobs with scenes, which another program carries out: it reads observations from stdout and writes
// controls to stdin (docs/many_runs.md).
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/cli/batch_protocol.h"
#include "core/base/os/process.h"
#include "core/document/batch/job.h"
#include "core/run/batch/episode.h"

namespace taxel::cli {

/// The answer to an observation: {"job": ID, "action": [...]}.
struct PolicyReply {
  std::string job;
  std::vector<double> action;
};

/// Throws Error("", JSON pointer, ...) if the line is not a reply.
PolicyReply parse_policy_reply(const std::string& line);

/// Asks the reader of the events for controls. Safe to use from several threads.
class PolicyDispatch {
 public:
  /// Starts to read stdin. The events must outlive the object.
  explicit PolicyDispatch(BatchEvents& events);
  ~PolicyDispatch();
  PolicyDispatch(const PolicyDispatch&) = delete;
  PolicyDispatch& operator=(const PolicyDispatch&) = delete;

  /// A JobPolicy. Throws BatchStopped if stdin has ended or the batch is to end.
  std::vector<double> act(const Job& job, const EpisodeScene& scene, const Episode& observation);

 private:
  void read(const std::stop_token& stop);

  BatchEvents& events_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable answered_;
  std::map<std::string, std::vector<double>> answers_;
  std::string failure_;  // reason why no more answers come; empty while they may
  std::jthread reader_;
};

}  // namespace taxel::cli
