// The memory of frames, reused when a frame is no longer used, so that making a frame costs only its copies.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/buffer_pool.h"
#include "core/run/history/step_history.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Makes frames. Any thread may release a frame last, also after this object is destroyed.
class FrameMemory {
 public:
  /// Returns a frame with a recorded step, or with the latest step of a simulator. All values that
  /// StepHistory::fill_step() or Simulator::fill_frame() do not set are as in a new frame.
  [[nodiscard]] std::shared_ptr<SimFrame> recorded_frame(const StepHistory& history, std::uint64_t step);
  [[nodiscard]] std::shared_ptr<SimFrame> frame_of(const Simulator& simulator);
  /// Returns a copy. If the reused memory has an earlier copy of the same edition, only new rows are copied.
  [[nodiscard]] std::shared_ptr<const Trace> copy_of(const Trace& trace);
  [[nodiscard]] std::shared_ptr<const HistoryLanes> lanes_of(const StepHistory& history);

 private:
  struct Frame {
    std::vector<Pose> geom_poses;
    std::vector<SensorStep> sensors;
    FilledHits hits;
  };
  template <class Fill>
  std::shared_ptr<SimFrame> make_frame(const Fill& fill);

  std::shared_ptr<BufferPool<Frame>> frames_ = std::make_shared<BufferPool<Frame>>();
  std::shared_ptr<BufferPool<Trace>> traces_ = std::make_shared<BufferPool<Trace>>();
  std::shared_ptr<BufferPool<HistoryLanes>> lanes_ = std::make_shared<BufferPool<HistoryLanes>>();
};

}  // namespace taxel
