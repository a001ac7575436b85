// A slot of the job executor in which only the newest job counts: it replaces a job that has not begun.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "app/studio/host/jobs/job_executor.h"
#include "core/base/progress.h"
#include "core/base/text/message.h"

namespace taxel::studio {

/// The fate of a running job when another job is posted.
enum class Superseded {
  finish,  ///< runs to its end; its result is used until the newer one is there
  cancel   ///< is cancelled through its Progress; its result is dropped
};

/// Runs one job at a time. Jobs compare with ==. All functions may be called from any thread. The owner destroys the
/// slot before the executor, and nobody else uses the slot then.
template <class Job, class Result>
class NewestWins {
 public:
  using ResultPtr = std::shared_ptr<const Result>;
  /// Fills the result of a job. Runs on a thread of the executor, never twice at the same time, so that the function
  /// may keep data for the next job. If it throws Cancelled, there is no result; the text of any other exception is
  /// stored in `Result::problem`, which a Work that throws must have.
  using Work = std::function<void(const Job&, Result&, Progress&)>;

  NewestWins(JobExecutor& executor, Priority priority, Work work)
      : executor_(executor), priority_(priority), work_(std::move(work)) {}
  /// Cancels the running job and waits for it. A job that has not begun is dropped.
  ~NewestWins() {
    {
      const std::lock_guard lock(mutex_);
      forget(Superseded::cancel);
    }
    executor_.remove(this);
  }
  NewestWins(const NewestWins&) = delete;
  NewestWins& operator=(const NewestWins&) = delete;

  /// Requests the result of a job, unless it is the job that was posted last. Without a job nothing is requested any
  /// more, and the newest result is forgotten. `frames` as in JobExecutor::post().
  void post(std::optional<Job> job, Superseded running = Superseded::finish, int frames = 0) {
    {
      const std::lock_guard lock(mutex_);
      if (!job) return forget(running);
      if (job_ && *job == *job_) return;
      job_ = std::move(job);
      is_pending_ = !has_reply();
      if (progress_ && running == Superseded::cancel) progress_->cancel();
      ended_.notify_all();
      if (!is_pending_) return;
    }
    executor_.post(
        this, priority_, [this] { run(); }, frames);
  }
  /// Stores a result that was found elsewhere. Dropped while no job is posted.
  void publish(const Job& job, ResultPtr result) {
    const std::lock_guard lock(mutex_);
    if (job_ && result) store(job, std::move(result));
  }
  /// Runs a job on the calling thread and publishes its result.
  void run_here(const Job& job) {
    Progress progress;
    publish(job, attempt(job, progress));
  }
  /// Returns the job that was posted last and whose result was not taken.
  [[nodiscard]] std::optional<Job> posted() const {
    const std::lock_guard lock(mutex_);
    return job_;
  }
  /// Returns the newest result, of the posted job or of an earlier one, or null.
  [[nodiscard]] ResultPtr newest() const {
    const std::lock_guard lock(mutex_);
    return newest_ ? newest_->second : nullptr;
  }
  /// Returns and forgets the newest result, and its job if that is the posted one. Null if there is no result.
  ResultPtr take() {
    const std::lock_guard lock(mutex_);
    if (!newest_) return nullptr;
    if (has_reply()) job_.reset();
    return std::exchange(newest_, std::nullopt)->second;
  }
  /// Waits until no job runs or is about to run.
  void wait() const {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return !is_pending_ && !progress_; });
  }
  [[nodiscard]] bool busy() const {
    const std::lock_guard lock(mutex_);
    return is_pending_ || progress_;
  }
  /// Returns the finished fraction of the running job, or 0 if none runs.
  [[nodiscard]] double fraction() const {
    const std::lock_guard lock(mutex_);
    return progress_ ? progress_->fraction() : 0;
  }
  /// Returns the name of the step that the running job is in; empty if none runs or it names none.
  [[nodiscard]] std::string step() const {
    const std::lock_guard lock(mutex_);
    return progress_ ? progress_->step() : "";
  }

 private:
  [[nodiscard]] bool has_reply() const { return newest_ && job_ == newest_->first; }
  void forget(Superseded running) {
    job_.reset();
    is_pending_ = false;
    newest_.reset();
    if (progress_ && running == Superseded::cancel) progress_->cancel();
    ended_.notify_all();
  }
  void store(const Job& job, ResultPtr result) {
    newest_ = {job, std::move(result)};
    if (has_reply()) is_pending_ = false;
    ended_.notify_all();
  }
  /// Runs a job on the calling thread. Returns null if the job was cancelled.
  [[nodiscard]] ResultPtr attempt(const Job& job, Progress& progress) {
    const std::lock_guard one_at_a_time(working_);
    auto result = std::make_shared<Result>();
    try {
      work_(job, *result, progress);
    } catch (const Cancelled&) {
      return nullptr;
    } catch (const std::exception& error) {
      if constexpr (requires { result->problem = shown_message(error); }) {
        result->problem = shown_message(error);
      } else {
        throw;
      }
    }
    return result;
  }
  void run() {
    std::unique_lock lock(mutex_);
    if (!std::exchange(is_pending_, false)) return;
    const Job job = *job_;
    const auto progress = progress_ = std::make_shared<Progress>();
    lock.unlock();
    ResultPtr result = attempt(job, *progress);
    lock.lock();
    progress_.reset();
    if (result && job_ && !has_reply() && !progress->cancelled()) store(job, std::move(result));
    ended_.notify_all();
    executor_.note_end();
  }

  JobExecutor& executor_;
  Priority priority_;
  Work work_;
  std::mutex working_;        // guards work_
  mutable std::mutex mutex_;  // guards the members below
  mutable std::condition_variable ended_;
  std::optional<Job> job_;
  bool is_pending_ = false;             ///< whether job_ has not begun
  std::shared_ptr<Progress> progress_;  ///< progress of the running job, or null
  std::optional<std::pair<Job, ResultPtr>> newest_;
};

}  // namespace taxel::studio
