#include "app/studio/host/jobs/inline_executor.h"

#include <algorithm>
#include <utility>

namespace taxel::studio {

void InlineExecutor::post(const void* slot, Priority /*priority*/, std::function<void()> task, int frames) {
  remove(slot);
  queue_.push_back({slot, std::move(task), frames > 0 ? frames + 1 : 0});
}

void InlineExecutor::remove(const void* slot) {
  std::erase_if(queue_, [&](const Task& task) { return task.slot == slot; });
}

void InlineExecutor::begin_frame(bool without_delay) {
  for (Task& task : queue_) task.frames_left = without_delay ? 0 : std::max(0, task.frames_left - 1);
}

void InlineExecutor::run_posted() {
  const auto is_due = [](const Task& task) { return task.frames_left == 0; };
  for (auto next = std::find_if(queue_.begin(), queue_.end(), is_due); next != queue_.end();
       next = std::find_if(queue_.begin(), queue_.end(), is_due)) {
    const std::function<void()> run = std::move(next->run);
    queue_.erase(next);
    run();
  }
}

}  // namespace taxel::studio
