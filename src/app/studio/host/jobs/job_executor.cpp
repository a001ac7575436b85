#include "app/studio/host/jobs/job_executor.h"

#include <algorithm>
#include <utility>

namespace taxel::studio {

JobPool::JobPool() {
  for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { work(); });
}

JobPool::~JobPool() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void JobPool::post(const void* slot, Priority priority, std::function<void()> task, int /*frames*/) {
  {
    const std::lock_guard lock(mutex_);
    if (std::any_of(queue_.begin(), queue_.end(), [&](const Task& queued) { return queued.slot == slot; })) return;
    queue_.push_back({slot, priority, std::move(task)});
  }
  changed_.notify_all();
}

void JobPool::remove(const void* slot) {
  std::unique_lock lock(mutex_);
  std::erase_if(queue_, [&](const Task& queued) { return queued.slot == slot; });
  changed_.wait(lock, [&] { return !is_running(slot); });
}

bool JobPool::busy() const {
  const std::lock_guard lock(mutex_);
  return !queue_.empty() || !running_.empty();
}

bool JobPool::is_running(const void* slot) const {
  return std::find(running_.begin(), running_.end(), slot) != running_.end();
}

/// The task to run next, or the queue's end if none may run now.
JobPool::Queue::iterator JobPool::find_next() {
  const auto find = [&](Priority priority) {
    return std::find_if(queue_.begin(), queue_.end(),
                        [&](const Task& task) { return task.priority == priority && !is_running(task.slot); });
  };
  const auto normal = find(Priority::normal);
  return normal != queue_.end() || background_ == kMaxBackground ? normal : find(Priority::background);
}

void JobPool::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    auto next = queue_.end();
    changed_.wait(lock, [&] { return is_ending_ || (next = find_next()) != queue_.end(); });
    if (is_ending_) return;
    const Task task = std::move(*next);
    queue_.erase(next);
    running_.push_back(task.slot);
    if (task.priority == Priority::background) ++background_;
    lock.unlock();
    task.run();
    lock.lock();
    if (task.priority == Priority::background) --background_;
    running_.erase(std::find(running_.begin(), running_.end(), task.slot));
    changed_.notify_all();
  }
}

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
