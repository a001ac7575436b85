// Where MuJoCo found that a simulation runs away.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

namespace taxel {

/// MuJoCo's first warning of a bad number, with the body or actuator that has it: "at body \"finger\": Nan, ...".
/// Empty: there is none.
std::string instability(const mjModel& m, const mjData& d);

}  // namespace taxel
