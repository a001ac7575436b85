// Servos whose damping MuJoCo integrates implicitly and that are too stiff for contact forces to know.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

namespace taxel {

/// Returns a sentence for each servo on a joint with h kv/m > 100 under the integrators implicit and implicitfast; kv
/// is its velocity gain at the joint and m the inertia of the joint at the initial pose. Contact forces take the force
/// of an actuator from the previous step (contact_forces.h). MuJoCo lowers the force of such a servo within the step by
/// the factor 1 + h kv/m, which the contact cannot know, so friction and damping are wrong in each step in which the
/// servo changes its velocity.
std::vector<std::string> stiff_servo_warnings(const mjModel& m);

}  // namespace taxel
