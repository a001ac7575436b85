// Plugins of others: actuators, sensors, signed distance functions.
#pragma once

#include <filesystem>

namespace taxel {

/// Loads every plugin library of a folder into MuJoCo, for scenes that name them: the folder `plugin` of MuJoCo itself,
/// or one of your own. Throws Error naming the folder: there is none, or it holds no plugin.
void load_plugin_folder(const std::filesystem::path& folder);

}  // namespace taxel
