// The playback of recorded steps, forwards or backwards, once or in a loop. It knows neither a clock nor the history.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/run/history/lanes.h"

namespace taxel {

/// The position of the playback.
class Replay {
 public:
  /// Starts at `step`, forwards (direction 1) or backwards (-1).
  void start(std::uint64_t step, int direction) {
    at_ = static_cast<double>(step);
    direction_ = direction;
  }
  void stop() { direction_ = 0; }
  [[nodiscard]] int direction() const { return direction_; }  ///< 0 if stopped

  /// Advances by `steps`, which need not be a whole number, and returns the step to display. At the end of the range
  /// the playback continues at the other end if `loop`, otherwise it stops.
  std::uint64_t advance(double steps, const StepRange& range, bool loop) {
    const auto first = static_cast<double>(range.first), last = static_cast<double>(range.last);
    at_ += direction_ * steps;
    if (loop) {
      const double length = last - first + 1;  // every step is displayed for the same time
      at_ = first + std::fmod(at_ - first, length);
      if (at_ < first) at_ += length;
    } else {
      const bool over = direction_ > 0 ? at_ >= last : at_ <= first;
      at_ = std::clamp(at_, first, last);
      if (over) stop();
    }
    return static_cast<std::uint64_t>(std::clamp(std::floor(at_), first, last));
  }

 private:
  double at_ = 0;
  int direction_ = 0;
};

}  // namespace taxel
