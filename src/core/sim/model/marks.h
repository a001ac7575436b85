// Sites, cameras and joints of a compiled model, and MuJoCo's figures of a step.
#pragma once

#include <mujoco/mujoco.h>

#include "core/run/marks.h"

namespace taxel {

/// Returns the sites that are not fully transparent, and all cameras and joints, in model order.
SceneMarks scene_marks(const mjModel& m);
/// Sets the poses in the state that was evaluated last. Reuses the memory of `poses`.
void pose_marks(const mjModel& m, const mjData& d, MarkPoses& poses);
/// Returns the figures of the latest step.
StepFacts step_facts(const mjModel& m, const mjData& d);

}  // namespace taxel
