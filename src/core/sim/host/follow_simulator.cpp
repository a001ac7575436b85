#include "core/sim/host/follow_simulator.h"

namespace taxel {

bool follow_latest_step(const Simulator& simulator, RunRecorder& recorder, StepView& view) {
  const Pose mocap{simulator.mocap_quat(), simulator.mocap_pos()};
  if (!simulator.row_due() && !recorder.needs_every_step()) {
    recorder.pass(mocap);
    return false;
  }
  simulator.view(view);
  recorder.follow(view, mocap, simulator.row_due());
  return true;
}

}  // namespace taxel
