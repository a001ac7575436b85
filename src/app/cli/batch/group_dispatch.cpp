#include "app/cli/batch/group_dispatch.h"

#include <fmt/format.h>

#include <chrono>

#include "core/run/batch/shard.h"

namespace taxel::cli {
namespace {

using Input = os::StandardInput;

/// Throws Error unless the bytes are the shard of the package's jobs. Returns the description of the shard.
ShardHead checked_head(const std::string& bytes, const JobPackage& package) {
  ShardHead head = read_shard_head(ParquetFile(bytes, "the result of group " + package.group));
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

}  // namespace taxel::cli
