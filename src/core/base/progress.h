// Progress of a long computation, and a way to stop it. One worker and one watcher share the object.
#pragma once

#include <atomic>

namespace taxel {

/// Exception that leaves a computation whose Progress was cancelled.
struct Cancelled {};

class Progress {
 public:
  void set(double fraction) {
    const double in_part = begin_ + fraction * (end_ - begin_);
    fraction_.store(part_begin_ + in_part * (part_end_ - part_begin_), std::memory_order_relaxed);
  }
  /// For workers: fractions recorded from now on are mapped to the range `begin` to `end` of the whole, so that the
  /// stages of a computation share one progress bar.
  void stage(double begin, double end) {
    begin_ = begin;
    end_ = end;
  }
  /// For workers: the same for a part that has stages of its own. All stages of it share the range `begin` to `end`.
  void part(double begin, double end) {
    part_begin_ = begin;
    part_end_ = end;
  }
  [[nodiscard]] double fraction() const { return fraction_.load(std::memory_order_relaxed); }
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
  double begin_ = 0, end_ = 1, part_begin_ = 0, part_end_ = 1;  // only used by the worker
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace taxel
