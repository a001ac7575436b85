// How long a simulation step takes: the mean of the latest ones.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace taxel {

class StepTime {
 public:
  using Duration = std::chrono::nanoseconds;  // whole numbers: the running sum stays exact

  void add(Duration step) {
    sum_ += step - latest_[next_];
    latest_[next_] = step;
    next_ = (next_ + 1) % kSteps;
    if (count_ < kSteps) ++count_;
  }

  /// 0 before the first step [s].
  [[nodiscard]] double mean_seconds() const {
    return count_ == 0 ? 0.0 : 1e-9 * static_cast<double>(sum_.count()) / static_cast<double>(count_);
  }

 private:
  static constexpr std::size_t kSteps = 256;  // long enough to read, short enough to follow a change of contact
  std::array<Duration, kSteps> latest_{};
  Duration sum_{0};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace taxel
