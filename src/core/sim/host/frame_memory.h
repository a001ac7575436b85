// What frames are made of, used again once nobody has them any more: a frame costs the simulation what it copies.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/shelf.h"
#include "core/run/history/step_history.h"
#include "core/sim/simulator.h"

namespace taxel {

/// The memory comes back from whatever thread lets go of a frame last, also after this object is gone.
class FrameMemory {
 public:
  /// A frame with the step of `history`, or with what the simulator shows; of both, what fill_frame() fills.
  [[nodiscard]] std::shared_ptr<SimFrame> recorded_frame(const StepHistory& history, std::uint64_t step);
  [[nodiscard]] std::shared_ptr<SimFrame> frame_of(const Simulator& simulator);
  /// A copy, of the same edition: of memory that held rows of that, only new ones are copied.
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

  std::shared_ptr<Shelf<Frame>> frames_ = std::make_shared<Shelf<Frame>>();
  std::shared_ptr<Shelf<Trace>> traces_ = std::make_shared<Shelf<Trace>>();
  std::shared_ptr<Shelf<HistoryLanes>> lanes_ = std::make_shared<Shelf<HistoryLanes>>();
};

}  // namespace taxel
