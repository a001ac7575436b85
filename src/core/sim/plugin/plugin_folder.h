// Loading of MuJoCo plugins that are not part of this project: actuators, sensors, signed distance functions.
#pragma once

#include <filesystem>

namespace taxel {

/// Loads every plugin library of a folder into MuJoCo, so that scenes can use the plugins. The folder is `plugin` of
/// MuJoCo itself or one of the user's. Throws Error naming the folder if it does not exist or has no plugin, or a
/// library that is not a regular file.
void load_plugin_folder(const std::filesystem::path& folder);

}  // namespace taxel
