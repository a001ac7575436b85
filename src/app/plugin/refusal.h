// Plugins of our names that refuse to work, for a MuJoCo with which the real ones cannot work.
#pragma once

#include <string>

#include "core/base/os/loaded_libraries.h"

namespace taxel {

/// Registers `taxel.sensor` and `taxel.contact` with a MuJoCo of any version from 3.0 on, so that each scene that uses
/// them fails to compile with `reason` instead of "plugin not found". Gives `reason` as a warning at once. Does nothing
/// to plugins of these names that are registered already.
void register_refusal(const os::LoadedLibrary& mujoco, const std::string& reason);

/// Returns true if another library of ours has registered a refusal with the MuJoCo that this library uses. MuJoCo
/// cannot replace a plugin.
bool is_refused();

}  // namespace taxel
