// The only entry point of the plugin library: it runs when MuJoCo loads the library.
#include <mujoco/mujoco.h>

#include <cstdio>
#include <string>
#include <vector>

#include "app/plugin/mujoco_functions.h"
#include "app/plugin/refusal.h"
#include "core/base/os/loaded_libraries.h"
#include "core/sim/plugin/plugin_table.h"

namespace taxel {
namespace {

/// Returns the reason for which the plugin cannot work in this MuJoCo, or an empty text if the plugin can.
/// `used` is the library that the plugin uses already, or null.
std::string reason_against(const os::LoadedLibrary& mujoco, const os::LoadedLibrary* used) {
  const std::string version = version_of(mujoco), own = TAXEL_MUJOCO_VERSION;
  if (version != own)
    return "this taxel plugin is built for MuJoCo " + own + ", but this is MuJoCo " + version +
           ": load the plugin that is built for MuJoCo " + version + " (there are plugins for " +
           TAXEL_MUJOCO_VERSIONS + ")";
  if (used != nullptr)
    return "this process has loaded MuJoCo " + version + " twice, from " + used->file + " and " + mujoco.file +
           ": the taxel plugin works only in the first one";
  return "";
}

/// Registers the plugins with the MuJoCo of this process. The library is not linked to a MuJoCo, because the dynamic
/// linker would then load one of its own into a process that has another version.
void load() {
  const std::vector<os::LoadedLibrary> mujocos = loaded_mujocos();
  if (mujocos.empty())
    std::fprintf(stderr, "taxel plugin: this process has no libmujoco.so: load the plugin from MuJoCo %s\n",
                 TAXEL_MUJOCO_VERSION);
  const os::LoadedLibrary* used = nullptr;
  for (const os::LoadedLibrary& mujoco : mujocos) {
    std::string reason = reason_against(mujoco, used);
    if (reason.empty()) {
      const std::string missing = use_functions_of(mujoco);
      if (missing.empty()) {
        if (is_refused())
          mju_warning(
              "a taxel plugin for another MuJoCo was loaded before this one and refuses all scenes: start a new "
              "process and load only the plugin for MuJoCo " TAXEL_MUJOCO_VERSION);
        register_sensor_plugin();
        used = &mujoco;
        continue;
      }
      reason = mujoco.file + " has no function " + missing + ", which the taxel plugin needs";
    }
    register_refusal(mujoco, reason);
  }
}

[[gnu::constructor]] void on_load() {
  load();
}

}  // namespace
}  // namespace taxel
