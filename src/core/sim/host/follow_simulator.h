// Records the latest step of a simulator.
#pragma once

#include "core/run/recording/run_recorder.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Lets `recorder` follow the latest step: with its values if a row is due or the recorder needs every step, otherwise
/// with the pose of the mocap body alone, which costs no view of the step. `view` is memory that is used again. Returns
/// whether the values were read. Throws the errors of RunRecorder::follow().
bool follow_latest_step(const Simulator& simulator, RunRecorder& recorder, StepView& view);

}  // namespace taxel
