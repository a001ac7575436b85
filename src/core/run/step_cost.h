// The parts of the wall time of the latest simulation steps, for drawing.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace taxel {

/// Wall times of the parts of one step [s].
struct StepCost {
  float mujoco = 0;    ///< mj_step without the sensors
  float surfaces = 0;  ///< poses, broad phase, contact surfaces
  float forces = 0;    ///< tractions, the implicit step
  float readings = 0;  ///< rays and aggregates
  float history = 0;   ///< recording the step
  [[nodiscard]] float sum() const { return mujoco + surfaces + forces + readings + history; }
};

/// Costs of the latest kSteps steps.
class StepCosts {
 public:
  static constexpr std::size_t kSteps = 240;
  void add(const StepCost& step) {
    latest_[next_] = step;
    next_ = (next_ + 1) % kSteps;
    if (count_ < kSteps) ++count_;
  }
  /// Returns the latest costs, oldest first.
  [[nodiscard]] std::vector<StepCost> latest() const {
    std::vector<StepCost> out;
    out.reserve(count_);
    for (std::size_t i = 0; i < count_; ++i) out.push_back(latest_[(next_ + kSteps - count_ + i) % kSteps]);
    return out;
  }

 private:
  std::array<StepCost, kSteps> latest_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace taxel
