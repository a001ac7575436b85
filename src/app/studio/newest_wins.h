// A worker thread of which only the newest job counts: what is asked for while it works replaces what was not begun.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace taxel::studio {

/// Jobs compare with ==. From any thread.
template <class Job, class Result>
class NewestWins {
 public:
  using ResultPtr = std::shared_ptr<const Result>;
  /// `work` runs in the worker and must not throw; `wake` is called from there when there is another result.
  NewestWins(std::function<ResultPtr(const Job&)> work, std::function<void()> wake)
      : work_(std::move(work)), wake_(std::move(wake)), thread_([this] { run(); }) {}
  ~NewestWins() {  ///< finishes what runs
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    asked_.notify_all();
    thread_.join();
  }
  NewestWins(const NewestWins&) = delete;
  NewestWins& operator=(const NewestWins&) = delete;

  /// To be done unless it is done, or asked for already; none: nothing any more.
  void ask(std::optional<Job> job) {
    {
      const std::lock_guard lock(mutex_);
      if (job && job_ && *job == *job_) return;
      job_ = std::move(job);
      due_ = job_ && !answered();
      if (!job_) newest_.reset();
      if (!due_) return;
    }
    asked_.notify_all();
  }
  /// A result that was found elsewhere. Dropped where nothing is asked for.
  void put(const Job& job, ResultPtr result) {
    const std::lock_guard lock(mutex_);
    if (job_) newest_ = {job, std::move(result)};
  }
  [[nodiscard]] std::optional<Job> asked() const {
    const std::lock_guard lock(mutex_);
    return job_;
  }
  /// The last result, of what is asked for or of what was asked for before; null: there is none.
  [[nodiscard]] ResultPtr newest() const {
    const std::lock_guard lock(mutex_);
    return newest_ ? newest_->second : nullptr;
  }
  void wait() {  ///< until what is asked for is done
    std::unique_lock lock(mutex_);
    told_.wait(lock, [this] { return !due_ && !working_; });
  }
  [[nodiscard]] bool busy() const {
    const std::lock_guard lock(mutex_);
    return due_ || working_;
  }

 private:
  [[nodiscard]] bool answered() const { return newest_ && newest_->first == *job_; }
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      asked_.wait(lock, [this] { return due_ || ending_; });
      if (ending_) return;
      const Job job = *job_;
      due_ = false;
      working_ = true;
      lock.unlock();
      ResultPtr result = work_(job);
      lock.lock();
      working_ = false;
      if (job_ && !answered()) newest_ = {job, std::move(result)};
      told_.notify_all();
      if (wake_) wake_();
    }
  }

  std::function<ResultPtr(const Job&)> work_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards the rest
  std::condition_variable asked_, told_;
  std::optional<Job> job_;  ///< what is to be shown
  bool due_ = false;        ///< it is not begun
  bool working_ = false, ending_ = false;
  std::optional<std::pair<Job, ResultPtr>> newest_;
  std::thread thread_;  // last: it begins when all is there
};

}  // namespace taxel::studio
