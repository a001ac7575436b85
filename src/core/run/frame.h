// A frame: one step with the state of the simulation around it. Everything drawn at one time comes from one SimFrame.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/run/history/breakpoints.h"
#include "core/run/history/lanes.h"
#include "core/run/step.h"

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

/// The recorded steps, each of which can be displayed again.
struct HistoryState {
  std::uint64_t first = 0, last = 0;  ///< range of the recorded steps
  std::size_t steps = 0;              ///< number of recorded steps
  std::size_t bytes = 0;              ///< memory that the recorded steps take
  double step_seconds = 0;            ///< mean wall time of recording a step, over the latest steps [s]
  StepHistoryLimits limits;
  /// Rows of the recorded steps; the newest rows may be missing. Never null.
  std::shared_ptr<const HistoryLanes> lanes;
};

/// The recording that is being made. It holds every step, whatever the limits of the history are.
struct RecordingState {
  bool on = false;
  std::size_t steps = 0, bytes = 0;  ///< number of recorded steps, and the memory that they take
  double seconds = 0;                ///< simulated time
};

/// A step, with the state of the simulation around it.
struct SimFrame : Step {
  bool playing = false;
  double speed = 1.0;                     ///< requested speed, in multiples of real time
  double measured_speed = 0;              ///< speed over the latest half second
  ControlValues controls;                 ///< values of scene->controls
  std::optional<PerturbShown> perturbed;  ///< empty while a recorded step is displayed
  std::shared_ptr<const Trace> trace;     ///< copied when a row is added, at most 30 times per second
  double step_seconds = 0;                ///< mean wall time of the latest steps [s]; 0 before the first step
  std::vector<StepCost> costs;            ///< costs of the latest steps, oldest first
  bool recorded = false;                  ///< a recorded step is displayed; the newest step is history.last
  /// Scene of the newest step; differs from `scene` if a later step has another layout.
  std::shared_ptr<const SimScene> simulated;
  HistoryState history;
  /// The previous step, after a FollowStepBeforeCommand, while the simulation does not run by itself and if the history
  /// holds the step. Otherwise null.
  StepPtr before;
  Breakpoints breakpoints;
  std::optional<Stop> stop;  ///< event that stopped the simulation; empty when the simulation continues
  std::uint64_t runs = 0;    ///< number of runs that were started
  RecordingState recording;
  bool failed = false;  ///< the simulation failed; it continues only from an earlier step or the start
  std::string error;    ///< why the simulation failed, or empty

  [[nodiscard]] StepId id() const { return {runs, step, scene ? scene->model_edition : 0}; }
};
using SimFramePtr = std::shared_ptr<const SimFrame>;

}  // namespace taxel
