// How far a long computation is, and a way to stop it. Shared by one worker and one watcher.
#pragma once

#include <atomic>

namespace taxel {

/// Thrown out of a computation whose Progress was cancelled.
struct Cancelled {};

class Progress {
 public:
  void set(double fraction) { fraction_.store(begin_ + fraction * (end_ - begin_), std::memory_order_relaxed); }
  /// For workers: what is set from now on counts from `begin` to `end` of the whole, so that the parts of a computation
  /// make one bar.
  void stage(double begin, double end) {
    begin_ = begin;
    end_ = end;
  }
  [[nodiscard]] double fraction() const { return fraction_.load(std::memory_order_relaxed); }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// For workers: note the fraction, throw Cancelled if the watcher asked to stop.
  void check(double fraction) {
    set(fraction);
    stop_if_cancelled();
  }
  /// The same without a fraction: from any thread of a worker.
  void stop_if_cancelled() const {
    if (cancelled()) throw Cancelled{};
  }

 private:
  double begin_ = 0, end_ = 1;  // the worker's own
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace taxel
