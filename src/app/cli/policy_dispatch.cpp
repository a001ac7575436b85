#include "app/cli/policy_dispatch.h"

#include <fmt/format.h>

#include <chrono>

#include "app/cli/signals.h"
#include "core/base/error.h"
#include "core/sim/batch/batch_stopped.h"

namespace taxel::cli {

PolicyDispatch::PolicyDispatch(BatchEvents& events) : events_(events) {
  reader_ = std::jthread([this](const std::stop_token& stop) { read(stop); });
}

PolicyDispatch::~PolicyDispatch() = default;

void PolicyDispatch::read(const std::stop_token& stop) {
  using Result = os::StandardInput::Result;
  os::StandardInput input;
  std::string line, failure = "stdin has ended: the program with the policy has stopped";
  try {
    while (!stop.stop_requested()) {
      const Result result = input.take_line(line);
      if (result == Result::ended) break;
      if (result == Result::waiting) continue;
      PolicyReply reply = parse_policy_reply(line);
      const std::scoped_lock lock(mutex_);
      answers_[reply.job] = std::move(reply.action);
      answered_.notify_all();
    }
  } catch (const Error& e) {
    failure = fmt::format("stdin: {}", e.what());
  }
  const std::scoped_lock lock(mutex_);
  failure_ = failure;
  answered_.notify_all();
}

std::vector<double> PolicyDispatch::act(const Job& job, const EpisodeScene& scene, const Episode& observation) {
  events_.observation(job, scene, observation);
  std::unique_lock lock(mutex_);
  for (;;) {
    if (auto answer = answers_.extract(job.id)) return std::move(answer.mapped());
    if (!failure_.empty() || received_signal() != 0) throw BatchStopped();
    answered_.wait_for(lock, std::chrono::milliseconds(100));
  }
}

}  // namespace taxel::cli
