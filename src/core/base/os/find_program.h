// Programs of the system that are found in PATH.
#pragma once

#include <string>

namespace taxel::os {

/// Returns whether a folder of PATH has a program of this name that may be run.
[[nodiscard]] bool has_program(const std::string& name);

}  // namespace taxel::os
