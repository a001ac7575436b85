// MuJoCo's functions in the plugin library, which forwards each call to the MuJoCo that the process has loaded.
#pragma once

#include <string>
#include <vector>

#include "core/base/os/loaded_libraries.h"

namespace taxel {

/// Returns the MuJoCo libraries of this process that can have plugins, in the order of their loading.
std::vector<os::LoadedLibrary> loaded_mujocos();

/// Returns the version of one of loaded_mujocos(), such as "4.0.1".
std::string version_of(const os::LoadedLibrary& mujoco);

/// Forwards all calls to the functions of this library from now on. Returns the name of a function that the library
/// lacks, or an empty text.
std::string use_functions_of(const os::LoadedLibrary& mujoco);

}  // namespace taxel
