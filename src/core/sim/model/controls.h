// The controls of a MuJoCo model and its data: descriptions, values, and changes.
#pragma once

#include <mujoco/mujoco.h>

#include <span>

#include "core/run/controls.h"

namespace taxel {

SceneControls scene_controls(const mjModel& m);

/// Returns the values in a saved state (mjSTATE_INTEGRATION), or in `d`.
ControlValues control_values(const mjModel& m, std::span<const mjtNum> integration);
ControlValues control_values(const mjModel& m, const mjData& d);

// The functions below ignore indices that the model does not have and values that are not finite, and clamp controls
// to their range. They return true if geoms may have moved.
bool set_control(const mjModel& m, mjData& d, const SetControl& edit);
bool set_joint(const mjModel& m, mjData& d, const SetJoint& edit);
bool set_mocap(const mjModel& m, mjData& d, const SetMocap& edit);
bool set_equality(const mjModel& m, mjData& d, const SetEquality& edit);

/// Returns the points of active connect and weld constraints, in the state that was evaluated last.
std::vector<ConstraintPoints> constraint_points(const mjModel& m, const mjData& d);

}  // namespace taxel
