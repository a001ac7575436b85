// The values that the device of a sensor reports, in the plugin: the chain of its layout (core/sensor/chain), whose
// state is the last part of the instance's plugin_state. MuJoCo saves, copies and restores that with its own state.
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <vector>

#include "core/sensor/chain/chain.h"

namespace taxel {

/// The reported values of one sensor of one mjData. Evaluating a state again changes nothing; only a step does.
class ReportedValues {
 public:
  /// `instance` is the plugin instance of the sensor. `layout` must have a calibration. Throws Error if the model was
  /// compiled with less state.
  ReportedValues(const mjModel& m, int instance, const Layout& layout);

  /// Computes the values of the present time. A time before that of the last step begins again, as a reset does.
  void evaluate(const mjModel& m, const mjData& d, std::span<const double> readings);
  /// Ignores the state of the mjData until the next step, because another chain has left it.
  void begin_again() { begins_again_ = true; }
  /// Stores the state that the last evaluate() has computed, at the end of a step.
  void advance(const mjModel& m, mjData& d);

  [[nodiscard]] const std::vector<double>& values() const { return values_; }  ///< values of the last evaluate()

  /// Returns the number of state values of an instance with this layout, which must have a calibration.
  static int state_size(const mjModel& m, const Layout& layout);

 private:
  [[nodiscard]] std::size_t begin_of_state(const mjModel& m) const;

  int instance_;
  Chain chain_;
  std::vector<double> next_state_, values_;
  bool has_next_state_ = false;  ///< false if sensors are off, and after advance()
  bool begins_again_ = false;
};

}  // namespace taxel
