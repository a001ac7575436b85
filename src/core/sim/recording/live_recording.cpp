#include "core/sim/recording/live_recording.h"

namespace taxel {

void LiveRecording::follow(const StepView& view, const Pose& mocap) {
  if (empty()) first_step_ = view.step;
  recorder_.follow(view, mocap, true);
}

void LiveRecording::go_back_to(std::uint64_t step) {
  recorder_.cut_after(step < first_step_ ? 0 : static_cast<std::size_t>(step - first_step_ + 1));
}

RecordingState LiveRecording::state() const {
  const std::size_t steps = recorder_.recording().rows.size();
  return {true, steps, recorder_.bytes(), static_cast<double>(steps) * scene_->timestep};
}

}  // namespace taxel
