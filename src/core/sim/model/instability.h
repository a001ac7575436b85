// The detection of an unstable simulation.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

namespace taxel {

/// Returns MuJoCo's first warning of a bad number, with its body or actuator: "at body \"finger\": Nan, ...". Empty if
/// there is no warning.
std::string instability(const mjModel& m, const mjData& d);

}  // namespace taxel
