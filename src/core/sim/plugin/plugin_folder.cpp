#include "core/sim/plugin/plugin_folder.h"

#include <mujoco/mujoco.h>

#include "core/base/error.h"

namespace taxel {

void load_plugin_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) throw Error(folder.string(), "is no folder");
  // MuJoCo opens every library of the folder, and waits for ever for the writer of a pipe.
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::filesystem::path extension = entry.path().extension();
    const bool is_library = extension == ".so" || extension == ".dylib" || extension == ".dll";
    if (is_library && entry.exists(ignored) && !entry.is_regular_file(ignored))
      throw Error(entry.path().string(), "is not a regular file");
  }
  const int before = mjp_pluginCount();
  mj_loadAllPluginLibraries(folder.c_str(), nullptr);
  if (mjp_pluginCount() == before) throw Error(folder.string(), "holds no plugin that MuJoCo loads");
}

}  // namespace taxel
