// Recorded steps played like a film: forwards or backwards, once or round and round. Knows neither clock nor history.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/run/history/lanes.h"

namespace taxel {

class Replay {
 public:
  /// direction: 1 forwards, -1 backwards.
  void start(std::uint64_t step, int direction) {
    at_ = static_cast<double>(step);
    direction_ = direction;
  }
  void stop() { direction_ = 0; }
  [[nodiscard]] int direction() const { return direction_; }  ///< 0: it stands

  /// The step to show after so many steps more, parts of one included. Past the end of the range it begins again at the
  /// other end, or stops there.
  std::uint64_t advance(double steps, const StepRange& range, bool loop) {
    const auto first = static_cast<double>(range.first), last = static_cast<double>(range.last);
    at_ += direction_ * steps;
    if (loop) {
      const double length = last - first + 1;  // each step is shown as long as the others
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
