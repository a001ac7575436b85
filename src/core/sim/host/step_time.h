// The mean wall time of the latest simulation steps.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace taxel {

/// The mean wall time of the latest kSteps steps.
class StepTime {
 public:
  using Duration = std::chrono::nanoseconds;  // whole numbers: the running sum stays exact

  void add(Duration step) {
    sum_ += step - latest_[next_];
    latest_[next_] = step;
    next_ = (next_ + 1) % kSteps;
    if (count_ < kSteps) ++count_;
  }

  /// Returns the mean [s]; 0 before the first step.
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
