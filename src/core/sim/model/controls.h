// What a hand can set in a MuJoCo model and its data.
#pragma once

#include <mujoco/mujoco.h>

#include <span>

#include "core/run/controls.h"

namespace taxel {

SceneControls scene_controls(const mjModel& m);

/// Of a saved state (mjSTATE_INTEGRATION).
ControlValues control_values(const mjModel& m, std::span<const mjtNum> integration);
ControlValues control_values(const mjModel& m, const mjData& d);

// Numbers outside of what the model has, and values that are no numbers, are left alone. Controls are held to their
// range. Return whether geoms may lie elsewhere now.
bool set_control(const mjModel& m, mjData& d, const SetControl& edit);
bool set_joint(const mjModel& m, mjData& d, const SetJoint& edit);
bool set_mocap(const mjModel& m, mjData& d, const SetMocap& edit);
bool set_equality(const mjModel& m, mjData& d, const SetEquality& edit);

/// The points that active connect and weld constraints hold together, as they lie in the state last evaluated.
std::vector<ConstraintPoints> constraint_points(const mjModel& m, const mjData& d);

}  // namespace taxel
