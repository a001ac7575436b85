#include "core/sim/host/scene_run.h"

namespace taxel {

SceneLeadPtr lead_simulator(Simulator& simulator, const LeadRequest& request, const std::string& scene) {
  const SceneControls& controls = simulator.scene()->controls;
  if (!request.keyframe.empty()) simulator.load_keyframe(keyframe_named(request.keyframe, controls, scene));
  if (request.files.is_empty()) return nullptr;
  SceneLeadPtr lead = read_lead(request.files, controls);
  simulator.lead(lead);
  return lead;
}

bool follow_latest_step(const Simulator& simulator, RunRecorder& recorder, StepView& view) {
  const Pose mocap = simulator.mocap_pose();
  if (!simulator.row_due() && !recorder.needs_every_step()) {
    recorder.pass(mocap);
    return false;
  }
  simulator.view(view);
  recorder.follow(view, mocap, simulator.row_due());
  return true;
}

}  // namespace taxel
