#include "app/studio/host/jobs/job_pool.h"

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

}  // namespace taxel::studio
