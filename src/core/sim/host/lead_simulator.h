// Starts a scene at a keyframe, and leads it by files.
#pragma once

#include <string>

#include "core/run/lead/read_lead.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Loads the keyframe and leads the simulator by the files. Returns the values that lead, or null if there are no
/// files. `scene` is the scene file for messages. Throws the errors of read_lead() and keyframe_named().
SceneLeadPtr lead_simulator(Simulator& simulator, const LeadRequest& request, const std::string& scene);

}  // namespace taxel
