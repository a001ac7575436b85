#include "core/sim/host/frame_memory.h"

#include <utility>

namespace taxel {
namespace {

/// Returns a shared value. The thread that releases the value last calls give_back(value).
template <class T, class GiveBack>
std::shared_ptr<T> shared(T value, GiveBack give_back) {
  return {std::make_unique<T>(std::move(value)).release(), [give_back = std::move(give_back)](T* done) {
            const std::unique_ptr<T> owner(done);
            give_back(*owner);
          }};
}

}  // namespace

/// Makes a new frame from reused memory, and fills it.
template <class Fill>
std::shared_ptr<SimFrame> FrameMemory::make_frame(const Fill& fill) {
  Frame memory = frames_->pop();
  SimFrame frame;
  frame.geom_poses = std::move(memory.geom_poses);
  frame.sensors = std::move(memory.sensors);
  fill(frame, memory.hits);
  return shared(std::move(frame), [pool = frames_, hits = std::move(memory.hits)](SimFrame& done) {
    for (SensorStep& sensor : done.sensors) sensor.model.reset();  // only memory is retained
    pool->put({std::move(done.geom_poses), std::move(done.sensors), hits});
  });
}

std::shared_ptr<SimFrame> FrameMemory::recorded_frame(const StepHistory& history, std::uint64_t step) {
  return make_frame([&](SimFrame& frame, FilledHits& hits) {
    hits.clear();
    history.fill_step(step, frame);
  });
}

std::shared_ptr<SimFrame> FrameMemory::frame_of(const Simulator& simulator) {
  return make_frame([&](SimFrame& frame, FilledHits& hits) { simulator.fill_frame(frame, hits); });
}

std::shared_ptr<const Trace> FrameMemory::copy_of(const Trace& trace) {
  Trace copy = traces_->pop();
  const std::size_t known = copy.rows.size();
  if (copy.edition == trace.edition && known <= trace.rows.size()) {
    copy.rows.insert(copy.rows.end(), trace.rows.begin() + static_cast<std::ptrdiff_t>(known), trace.rows.end());
  } else {
    copy = trace;
  }
  return shared(std::move(copy), [pool = traces_](Trace& done) { pool->put(std::move(done)); });
}

std::shared_ptr<const HistoryLanes> FrameMemory::lanes_of(const StepHistory& history) {
  HistoryLanes lanes = lanes_->pop();
  history.copy_lanes(lanes);
  return shared(std::move(lanes), [pool = lanes_](HistoryLanes& done) { pool->put(std::move(done)); });
}

}  // namespace taxel
