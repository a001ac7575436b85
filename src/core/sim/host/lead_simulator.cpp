#include "core/sim/host/lead_simulator.h"

namespace taxel {

SceneLeadPtr lead_simulator(Simulator& simulator, const LeadRequest& request, const std::string& scene) {
  const SceneControls& controls = simulator.scene()->controls;
  if (!request.keyframe.empty()) simulator.load_keyframe(keyframe_named(request.keyframe, controls, scene));
  if (request.files.is_empty()) return nullptr;
  SceneLeadPtr lead = read_lead(request.files, controls);
  simulator.lead(lead);
  return lead;
}

}  // namespace taxel
