// The threads that run the jobs of all slots.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "app/studio/host/jobs/job_executor.h"

namespace taxel::studio {

/// Runs queued tasks, those of normal priority first and otherwise in the order in which they were posted. A slot is
/// known by its address. Two tasks of one slot never run at the same time. All functions may be called from any thread.
class JobPool final : public JobExecutor {
 public:
  static constexpr int kThreads = 4, kMaxBackground = 2;

  JobPool();
  /// Drops queued tasks and waits for running ones. No slot may outlive the pool.
  ~JobPool() override;

  [[nodiscard]] bool busy() const override;
  void post(const void* slot, Priority priority, std::function<void()> task, int frames = 0) override;
  void remove(const void* slot) override;
  void begin_frame(bool /*without_delay*/) override {}
  void run_posted() override {}

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

  mutable std::mutex mutex_;  // guards all members except threads_
  std::condition_variable changed_;
  Queue queue_;
  std::vector<const void*> running_;  ///< slots whose task runs
  int background_ = 0;                ///< running tasks of background priority
  bool is_ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace taxel::studio
