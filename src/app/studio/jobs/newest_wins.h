// A worker thread of which only the newest job counts: what is asked for while it works replaces what was not begun.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/base/progress.h"

namespace taxel::studio {

/// What becomes of a job that is being done when another is asked for.
enum class Overtaken {
  finish,  ///< its result is shown meanwhile
  cancel   ///< through its Progress
};

/// Jobs compare with ==. From any thread.
template <class Job, class Result>
class NewestWins {
 public:
  using ResultPtr = std::shared_ptr<const Result>;
  using Work = std::function<ResultPtr(const Job&, Progress&)>;
  /// `work` runs in the worker and throws nothing but Cancelled; `wake` is called from there when there is another
  /// result.
  NewestWins(Work work, std::function<void()> wake, Overtaken overtaken = Overtaken::finish)
      : work_(std::move(work)), wake_(std::move(wake)), overtaken_(overtaken), thread_([this] { run(); }) {}
  ~NewestWins() {  ///< waits for what runs
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      overtake();
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
      overtake();
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
    told_.wait(lock, [this] { return !due_ && !progress_; });
  }
  /// How far what is being done is; 0: nothing is.
  [[nodiscard]] double fraction() const {
    const std::lock_guard lock(mutex_);
    return progress_ ? progress_->fraction() : 0;
  }
  [[nodiscard]] bool busy() const {
    const std::lock_guard lock(mutex_);
    return due_ || progress_;
  }

 private:
  [[nodiscard]] bool answered() const { return newest_ && newest_->first == *job_; }
  void overtake() {
    if (progress_ && overtaken_ == Overtaken::cancel) progress_->cancel();
  }
  /// Null: it was cancelled.
  [[nodiscard]] ResultPtr attempt(const Job& job, Progress& progress) const {
    try {
      return work_(job, progress);
    } catch (const Cancelled&) {
      return nullptr;
    }
  }
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      asked_.wait(lock, [this] { return due_ || ending_; });
      if (ending_) return;
      const Job job = *job_;
      due_ = false;
      const auto progress = progress_ = std::make_shared<Progress>();
      lock.unlock();
      ResultPtr result = attempt(job, *progress);
      lock.lock();
      progress_.reset();
      if (result && job_ && !answered()) newest_ = {job, std::move(result)};
      told_.notify_all();
      if (wake_) wake_();
    }
  }

  Work work_;
  std::function<void()> wake_;
  Overtaken overtaken_;
  mutable std::mutex mutex_;  // guards the rest
  std::condition_variable asked_, told_;
  std::optional<Job> job_;  ///< what is to be shown
  bool due_ = false;        ///< it is not begun
  bool ending_ = false;
  std::shared_ptr<Progress> progress_;  ///< of what is being done; null: nothing is
  std::optional<std::pair<Job, ResultPtr>> newest_;
  std::thread thread_;  // last: it begins when all is there
};

}  // namespace taxel::studio
