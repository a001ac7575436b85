// What viewers mark in a compiled model beside its geoms, and what MuJoCo says of a step.
#pragma once

#include <mujoco/mujoco.h>

#include "core/run/marks.h"

namespace taxel {

/// Sites that are not fully transparent, all cameras and joints, in model order.
SceneMarks scene_marks(const mjModel& m);
/// In the state last evaluated. Keeps the memory of `poses`.
void pose_marks(const mjModel& m, const mjData& d, MarkPoses& poses);
/// Of the step just made.
StepFacts step_facts(const mjModel& m, const mjData& d);

}  // namespace taxel
