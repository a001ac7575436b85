#include "app/studio/pattern_worker.h"

#include <utility>

#include "core/base/error.h"

namespace taxel::studio {

namespace {

/// None: it was cancelled.
std::optional<PatternAnswer> answer_to(const PatternRequest& request, Progress& progress) {
  PatternAnswer answer;
  answer.number = request.number;
  try {
    answer.made = make_pattern(request.pattern, request.source, *request.skin, &progress);
  } catch (const Cancelled&) {
    return std::nullopt;
  } catch (const std::exception& error) {
    answer.problem = error.what();
  }
  return answer;
}

}  // namespace

PatternWorker::PatternWorker(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { run(); }) {}

PatternWorker::~PatternWorker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    if (progress_) progress_->cancel();
  }
  asked_.notify_all();
  thread_.join();
}

void PatternWorker::make(PatternRequest request) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(request);
    ready_.reset();
    if (progress_) progress_->cancel();
  }
  asked_.notify_all();
}

void PatternWorker::drop() {
  const std::lock_guard lock(mutex_);
  next_.reset();
  ready_.reset();
  if (progress_) progress_->cancel();
}

std::optional<PatternAnswer> PatternWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(ready_, std::nullopt);
}

void PatternWorker::wait() {
  std::unique_lock lock(mutex_);
  told_.wait(lock, [this] { return !next_ && !progress_; });
}

bool PatternWorker::busy() const {
  const std::lock_guard lock(mutex_);
  return next_ || ready_ || progress_;
}

void PatternWorker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    asked_.wait(lock, [this] { return next_ || ending_; });
    if (ending_) return;
    const PatternRequest request = std::move(*std::exchange(next_, std::nullopt));
    const auto progress = progress_ = std::make_shared<Progress>();
    lock.unlock();
    std::optional<PatternAnswer> answer = answer_to(request, *progress);
    lock.lock();
    if (answer && !progress->cancelled()) ready_ = std::move(answer);
    progress_.reset();
    told_.notify_all();
    if (ready_ && wake_) wake_();
  }
}

}  // namespace taxel::studio
