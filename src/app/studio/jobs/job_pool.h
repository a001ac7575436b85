// The threads that run the jobs of all slots.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace taxel::studio {

enum class Priority {
  normal,     ///< the user waits for the result
  background  ///< takes seconds or minutes; at most JobPool::kMaxBackground run at once
};

/// Runs queued tasks, those of normal priority first and otherwise in the order in which they were posted. A slot is
/// known by its address. Two tasks of one slot never run at the same time. All functions may be called from any thread.
class JobPool {
 public:
  static constexpr int kThreads = 4, kMaxBackground = 2;

  JobPool();
  /// Drops queued tasks and waits for running ones. No slot may outlive the pool.
  ~JobPool();
  JobPool(const JobPool&) = delete;
  JobPool& operator=(const JobPool&) = delete;

  /// Queues a task, unless a task of the slot is queued already. `task` must not throw.
  void post(const void* slot, Priority priority, std::function<void()> task);
  /// Drops the queued task of a slot and waits for its running one, so that the slot can be destroyed. Must not be
  /// called by a task of the same slot.
  void remove(const void* slot);

 private:
  struct Task {
    const void* slot;
    Priority priority;
    std::function<void()> run;
  };
  using Queue = std::deque<Task>;

  void work();
  [[nodiscard]] bool is_running(const void* slot) const;
  [[nodiscard]] Queue::iterator find_next();

  std::mutex mutex_;  // guards all members except threads_
  std::condition_variable changed_;
  Queue queue_;
  std::vector<const void*> running_;  ///< slots whose task runs
  int background_ = 0;                ///< running tasks of background priority
  bool is_ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace taxel::studio
