#include "core/sim/host/live_recording.h"

#include "core/base/error.h"

namespace taxel {

template <class Write>
void LiveRecording::keep(const Write& write) {
  if (!journal_) return;
  try {
    write(*journal_);
  } catch (const Error& error) {
    if (!std::exchange(has_failed_, true)) failure_ = error.what();
  }
}

void LiveRecording::follow(const StepView& view, const Pose& mocap) {
  if (empty()) first_step_ = view.step;
  recorder_.follow(view, mocap, true);
  keep([this](RecordingJournal& journal) { journal.follow(recorder_.recording()); });
}

void LiveRecording::go_back_to(std::uint64_t step) {
  recorder_.cut_after(step < first_step_ ? 0 : static_cast<std::size_t>(step - first_step_ + 1));
  keep([this](RecordingJournal& journal) { journal.cut_to(recorder_.recording()); });
}

RecordingState LiveRecording::state() const {
  const std::size_t steps = recorder_.recording().rows.size();
  return {true, steps, recorder_.bytes(), static_cast<double>(steps) * scene_->timestep};
}

}  // namespace taxel
