// Progress of a long computation, and a way to stop it. One worker and one watcher share the object.
#pragma once

#include <atomic>

namespace taxel {

/// Exception that leaves a computation whose Progress was cancelled.
struct Cancelled {};

class Progress {
 public:
  /// For workers: records the finished fraction, of the whole or of the ProgressPart that the worker is in.
  void set(double fraction) {
    fraction_.store(range_.begin + fraction * (range_.end - range_.begin), std::memory_order_relaxed);
  }
  /// For workers: the fraction that was recorded last, of the part that the worker is in.
  [[nodiscard]] double reached() const {
    const double width = range_.end - range_.begin;
    return width > 0 ? (fraction() - range_.begin) / width : 0;
  }
  [[nodiscard]] double fraction() const { return fraction_.load(std::memory_order_relaxed); }
  /// For workers: records the name of the step that begins, as in "Filling holes": a literal.
  void set_step(const char* name) { step_.store(name, std::memory_order_relaxed); }
  /// The name of the step that the worker is in, or "".
  [[nodiscard]] const char* step() const { return step_.load(std::memory_order_relaxed); }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// For workers: records the fraction, and throws Cancelled if the watcher requested to stop.
  void check(double fraction) {
    set(fraction);
    stop_if_cancelled();
  }
  /// Throws Cancelled if the watcher requested to stop. May be called from any thread of a worker.
  void stop_if_cancelled() const {
    if (cancelled()) throw Cancelled{};
  }

 private:
  friend class ProgressPart;
  struct Range {
    double begin = 0, end = 1;
  };

  Range range_;  // only used by the worker
  std::atomic<double> fraction_{0.0};
  std::atomic<const char*> step_{""};
  std::atomic<bool> cancelled_{false};
};

/// A part of a computation that reports its own progress from 0 to 1. While it exists, fractions recorded in
/// `progress`, if there is one, become the range `begin` to `end` of the part that it lies in, or of the whole.
class ProgressPart {
 public:
  ProgressPart(Progress* progress, double begin, double end) : progress_(progress) {
    if (progress_ == nullptr) return;
    outer_ = progress_->range_;
    const double width = outer_.end - outer_.begin;
    progress_->range_ = {outer_.begin + begin * width, outer_.begin + end * width};
  }
  ~ProgressPart() {
    if (progress_ != nullptr) progress_->range_ = outer_;
  }
  ProgressPart(const ProgressPart&) = delete;
  ProgressPart& operator=(const ProgressPart&) = delete;

 private:
  Progress* progress_;
  Progress::Range outer_;
};

}  // namespace taxel
