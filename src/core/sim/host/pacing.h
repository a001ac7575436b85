// Keeps simulated time in step with a clock, at a requested speed. Callers pass the time of the clock [s].
#pragma once

#include <deque>

namespace taxel {

/// The pace of a simulation.
class Pacing {
 public:
  /// Restarts: from `now` on, simulated time runs at `speed` times the clock.
  void restart(double now, double speed) {
    begin_ = now;
    speed_ = speed;
    simulated_ = 0;
    history_.clear();
    history_.push_back({now, 0.0});
  }

  /// Registers a step of length `timestep`. A simulation that is too slow does not catch up later: a lag beyond kMaxLag
  /// is ignored.
  void advance(double timestep, double now) {
    simulated_ += timestep;
    const double behind = (now - begin_) - simulated_ / speed_;
    if (behind > kMaxLag) begin_ += behind - kMaxLag;
    history_.push_back({now, simulated_});
    while (history_.size() > 2 && now - history_.front().clock > kWindow) history_.pop_front();
  }

  /// Returns the time until the next step is due [s]; 0 or less if the step is due.
  [[nodiscard]] double wait(double now) const { return begin_ + simulated_ / speed_ - now; }

  /// Returns the simulated time divided by the real time, over the last kWindow seconds.
  [[nodiscard]] double measured_speed(double now) const {
    if (history_.empty() || !(now > history_.front().clock)) return 0.0;
    return (simulated_ - history_.front().simulated) / (now - history_.front().clock);
  }

 private:
  static constexpr double kMaxLag = 0.05;  // [s]
  static constexpr double kWindow = 0.5;   // [s]
  struct Mark {
    double clock = 0, simulated = 0;
  };
  double begin_ = 0, speed_ = 1, simulated_ = 0;
  std::deque<Mark> history_;
};

/// When frames are due: at most one each `interval`, and that many on average, although they are made somewhat late.
class FrameSchedule {
 public:
  explicit FrameSchedule(double interval) : interval_(interval) {}

  [[nodiscard]] bool is_due(double now) const { return now >= due_; }

  /// Registers a frame made at `now`. The next one is due one interval after this one was, or, if this one is late by
  /// more than an interval or was not due, after `now`.
  void made(double now) {
    const bool in_time = is_due(now) && now - due_ < interval_;
    due_ = (in_time ? due_ : now) + interval_;
  }

 private:
  double interval_;
  double due_ = 0;  // [s] time of the clock at which the next frame is due
};

}  // namespace taxel
