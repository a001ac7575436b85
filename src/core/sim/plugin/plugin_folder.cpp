#include "core/sim/plugin/plugin_folder.h"

#include <mujoco/mujoco.h>

#include "core/base/error.h"

namespace taxel {

void load_plugin_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) throw Error(folder.string(), "is no folder");
  const int before = mjp_pluginCount();
  mj_loadAllPluginLibraries(folder.c_str(), nullptr);
  if (mjp_pluginCount() == before) throw Error(folder.string(), "holds no plugin that MuJoCo loads");
}

}  // namespace taxel
