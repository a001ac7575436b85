// Keeps simulated time beside the clock, at a wanted speed. Knows no clock itself: callers say what time it is [s].
#pragma once

#include <deque>

namespace taxel {

class Pacing {
 public:
  /// Begins anew: from `now` on, simulated time runs at `speed` times the clock.
  void restart(double now, double speed) {
    begin_ = now;
    speed_ = speed;
    simulated_ = 0;
    history_.clear();
    history_.push_back({now, 0.0});
  }

  /// A step of `timestep` was made. A simulation that cannot keep up does not try to catch up later: what it is behind
  /// by more than kMaxLag is forgiven.
  void advance(double timestep, double now) {
    simulated_ += timestep;
    const double behind = (now - begin_) - simulated_ / speed_;
    if (behind > kMaxLag) begin_ += behind - kMaxLag;
    history_.push_back({now, simulated_});
    while (history_.size() > 2 && now - history_.front().clock > kWindow) history_.pop_front();
  }

  /// How long until the next step is due; 0 or less when it is.
  [[nodiscard]] double wait(double now) const { return begin_ + simulated_ / speed_ - now; }

  /// Simulated time over clock time of the last kWindow seconds.
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

}  // namespace taxel
