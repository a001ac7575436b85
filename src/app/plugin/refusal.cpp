#include "app/plugin/refusal.h"

#include <mujoco/mujoco.h>

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/sim/plugin/plugin_instances.h"

namespace taxel {
namespace {

/// One MuJoCo whose scenes are refused. The functions are those of this MuJoCo, found by name.
struct Refused {
  std::string reason;
  decltype(&mju_warning) warn = nullptr;
};
constexpr std::size_t kMostRefused = 4;  // more MuJoCos than any process has

/// The refused MuJoCos. A function's variable exists even when other initialisers of the library have not run yet.
std::vector<Refused>& refused() {
  static std::vector<Refused> all;
  return all;
}

// These functions must not look into their arguments, which have the layout of another version.
int no_values(const mjModel*, int) {
  return 0;
}
int no_sensor_values(const mjModel*, int, int) {
  return 0;
}
void ignore_reset(const mjModel*, mjtNum*, void*, int) {}
void ignore_compute(const mjModel*, mjData*, int, int) {}

/// Fails, so that the compilation fails. MuJoCo reports the warning as its reason.
template <std::size_t number>
int refuse(const mjModel*, mjData*, int) {
  const Refused& mujoco = refused()[number];
  mujoco.warn("%s", mujoco.reason.c_str());
  return -1;
}

template <std::size_t... numbers>
constexpr std::array<decltype(mjpPlugin::init), sizeof...(numbers)> refusals(std::index_sequence<numbers...>) {
  return {refuse<numbers>...};
}
constexpr auto kRefusals = refusals(std::make_index_sequence<kMostRefused>{});

/// A plugin in any version of MuJoCo. The members that are set here have had their places since MuJoCo 3.0; a later
/// version may have more members than ours.
union AnyPlugin {
  mjpPlugin plugin;
  std::array<unsigned char, 4096> room;
};

template <class Function>
Function function_of(const os::LoadedLibrary& mujoco, const char* name) {
  return reinterpret_cast<Function>(os::find_function(mujoco, name));
}

void register_one(const os::LoadedLibrary& mujoco, const char* name, std::span<const char* const> keys) {
  const auto get_default = function_of<decltype(&mjp_defaultPlugin)>(mujoco, "mjp_defaultPlugin");
  const auto get = function_of<decltype(&mjp_getPlugin)>(mujoco, "mjp_getPlugin");
  const auto add = function_of<decltype(&mjp_registerPlugin)>(mujoco, "mjp_registerPlugin");
  if (get_default == nullptr || get == nullptr || add == nullptr || get(name, nullptr) != nullptr) return;
  AnyPlugin any{.room = {}};
  mjpPlugin& plugin = any.plugin;
  get_default(&plugin);
  plugin.name = name;
  plugin.nattribute = static_cast<int>(keys.size());
  plugin.attributes = keys.data();
  plugin.capabilityflags = mjPLUGIN_PASSIVE | mjPLUGIN_SENSOR;
  plugin.needstage = mjSTAGE_ACC;
  plugin.nstate = no_values;
  plugin.nsensordata = no_sensor_values;
  plugin.init = kRefusals[refused().size() - 1];
  plugin.reset = ignore_reset;
  plugin.compute = ignore_compute;
  add(&plugin);
}

}  // namespace

bool is_refused() {
  const mjpPlugin* present = mjp_getPlugin(kPluginName, nullptr);
  return present != nullptr && present->copy == nullptr;  // the real plugin can copy its data
}

void register_refusal(const os::LoadedLibrary& mujoco, const std::string& reason) {
  const auto warn = function_of<decltype(&mju_warning)>(mujoco, "mju_warning");
  if (warn == nullptr || refused().size() == kMostRefused) return;
  refused().push_back({reason, warn});
  register_one(mujoco, kPluginName, kSensorKeys);
  register_one(mujoco, kContactPluginName, kContactKeys);
  warn("%s", reason.c_str());
}

}  // namespace taxel
