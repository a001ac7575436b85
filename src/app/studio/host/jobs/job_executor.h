// Runs the jobs of all slots: on threads, or on the thread of the caller.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace taxel::studio {

enum class Priority {
  normal,     ///< the user waits for the result
  background  ///< takes seconds or minutes; at most JobPool::kMaxBackground run at once
};

/// Runs queued tasks. A slot is known by its address; two tasks of one slot never run at the same time.
class JobExecutor {
 public:
  JobExecutor() = default;
  virtual ~JobExecutor() = default;
  JobExecutor(const JobExecutor&) = delete;
  JobExecutor& operator=(const JobExecutor&) = delete;

  /// Sets the function that is called on any thread each time that a job has ended, whatever its kind: it wakes the
  /// window. To be called before the first task is posted.
  void set_wake(std::function<void()> wake) { wake_ = std::move(wake); }
  /// Returns the number of jobs that have ended, with or without a result. When it changes, the window has something to
  /// draw.
  [[nodiscard]] std::uint64_t ended() const { return ended_; }
  /// To be called by a slot at the end of a job, when others can see its result.
  void note_end() {
    ++ended_;
    if (wake_) wake_();
  }
  /// Whether a task is queued or runs.
  [[nodiscard]] virtual bool busy() const = 0;

  /// Queues a task, which must not throw, unless a task of the slot is queued: the tasks of a slot are equal. `frames`
  /// is the number of further frames that a script sees before the task runs.
  virtual void post(const void* slot, Priority priority, std::function<void()> task, int frames = 0) = 0;
  /// Drops the queued task of a slot and waits for its running one, so that the slot can be destroyed. Must not be
  /// called by a task of the same slot.
  virtual void remove(const void* slot) = 0;
  /// Begins a frame. If `without_delay`, no queued task waits for further frames.
  virtual void begin_frame(bool without_delay) = 0;
  /// Runs the queued tasks whose frames have passed, if no thread runs them.
  virtual void run_posted() = 0;

 private:
  std::function<void()> wake_;
  std::atomic<std::uint64_t> ended_{0};
};

/// The threads that run the jobs of all slots. Runs queued tasks, those of normal priority first and otherwise in the
/// order in which they were posted. A slot is known by its address. Two tasks of one slot never run at the same time.
/// All functions may be called from any thread.
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

/// Runs jobs on the thread of the caller in the order in which they were posted, so that a script always sees the same.
/// Belongs to one thread.
class InlineExecutor final : public JobExecutor {
 public:
  [[nodiscard]] bool busy() const override { return !queue_.empty(); }
  void post(const void* slot, Priority priority, std::function<void()> task, int frames = 0) override;
  void remove(const void* slot) override;
  void begin_frame(bool without_delay) override;
  void run_posted() override;

 private:
  struct Task {
    const void* slot;
    std::function<void()> run;
    int frames_left;  ///< number of frames to begin before the task runs
  };

  std::vector<Task> queue_;
};

}  // namespace taxel::studio
