// The run of a scene by a program: its start at a keyframe, the files that lead it, and the recording of its steps.
#pragma once

#include <string>

#include "core/run/lead.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Loads the keyframe and leads the simulator by the files. Returns the values that lead, or null if there are no
/// files. `scene` is the scene file for messages. Throws the errors of read_lead() and keyframe_named().
SceneLeadPtr lead_simulator(Simulator& simulator, const LeadRequest& request, const std::string& scene);

/// Lets `recorder` follow the latest step: with its values if a row is due or the recorder needs every step, otherwise
/// with the pose of the mocap body alone, which costs no view of the step. `view` is memory that is used again. Returns
/// whether the values were read. Throws the errors of RunRecorder::follow().
bool follow_latest_step(const Simulator& simulator, RunRecorder& recorder, StepView& view);

}  // namespace taxel
