// The plugin library's only entry point, which runs when a process loads the library, and MuJoCo's functions in it,
// which forward each call to the MuJoCo that the process has loaded: the library is not linked to any.
#include <mujoco/mujoco.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/os/process.h"
#include "core/sensor/stored_samples.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/plugin/plugin_table.h"

// Each function of MuJoCo that the plugin calls: result, name, parameters, arguments. A function that is not listed is
// an undefined symbol when the library is linked.
#define TAXEL_MUJOCO_FUNCTIONS(F)                                                                                    \
  F(void, mj_applyFT,                                                                                                \
    (const mjModel* m, mjData* d, const mjtNum force[3], const mjtNum torque[3], const mjtNum point[3], int body,    \
     mjtNum* qfrc_target),                                                                                           \
    (m, d, force, torque, point, body, qfrc_target))                                                                 \
  F(void, mj_contactForce, (const mjModel* m, const mjData* d, int id, mjtNum result[6]), (m, d, id, result))        \
  F(void, mj_deleteData, (mjData * d), (d))                                                                          \
  F(void, mj_fwdActuation, (const mjModel* m, mjData* d), (m, d))                                                    \
  F(const char*, mj_getPluginConfig, (const mjModel* m, int plugin_id, const char* attrib), (m, plugin_id, attrib))  \
  F(const char*, mj_id2name, (const mjModel* m, int type, int id), (m, type, id))                                    \
  F(void, mj_jac, (const mjModel* m, const mjData* d, mjtNum* jacp, mjtNum* jacr, const mjtNum point[3], int body),  \
    (m, d, jacp, jacr, point, body))                                                                                 \
  F(void, mj_objectVelocity,                                                                                         \
    (const mjModel* m, const mjData* d, int objtype, int objid, mjtNum res[6], int flg_local),                       \
    (m, d, objtype, objid, res, flg_local))                                                                          \
  F(void, mj_rne, (const mjModel* m, mjData* d, int flg_acc, mjtNum* result), (m, d, flg_acc, result))               \
  F(void, mj_solveM, (const mjModel* m, mjData* d, mjtNum* x, const mjtNum* y, int n), (m, d, x, y, n))              \
  F(void, mjp_defaultPlugin, (mjpPlugin * plugin), (plugin))                                                         \
  F(const mjpPlugin*, mjp_getPlugin, (const char* name, int* slot), (name, slot))                                    \
  F(const mjpPlugin*, mjp_getPluginAtSlot, (int slot), (slot))                                                       \
  F(int, mjp_registerPlugin, (const mjpPlugin* plugin), (plugin))                                                    \
  F(void, mjv_connector, (mjvGeom * geom, int type, mjtNum width, const mjtNum from[3], const mjtNum to[3]),         \
    (geom, type, width, from, to))                                                                                   \
  F(void, mjv_initGeom,                                                                                              \
    (mjvGeom * geom, int type, const mjtNum size[3], const mjtNum pos[3], const mjtNum mat[9], const float rgba[4]), \
    (geom, type, size, pos, mat, rgba))                                                                              \
  F(mjtNum, mju_dot, (const mjtNum* vec1, const mjtNum* vec2, int n), (vec1, vec2, n))                               \
  F(void, mju_mulMatVec, (mjtNum * res, const mjtNum* mat, const mjtNum* vec, int nr, int nc), (res, mat, vec, nr, nc))

namespace {

#define TAXEL_POINTER(result, name, parameters, arguments) decltype(&name) name##_in_process = nullptr;
TAXEL_MUJOCO_FUNCTIONS(TAXEL_POINTER)
#undef TAXEL_POINTER
decltype(&mju_warning) mju_warning_in_process = nullptr;
decltype(&mju_error) mju_error_in_process = nullptr;

}  // namespace

extern "C" {

#define TAXEL_FORWARD(result, name, parameters, arguments) \
  result name parameters {                                 \
    return name##_in_process arguments;                    \
  }
TAXEL_MUJOCO_FUNCTIONS(TAXEL_FORWARD)
#undef TAXEL_FORWARD

void mju_warning(const char* format, ...) {
  char text[1024];  // MuJoCo itself keeps no more
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  mju_warning_in_process("%s", text);
}

void mju_error(const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  mju_error_in_process("%s", text);
}

}  // extern "C"

namespace taxel {
namespace {

template <class Function>
bool find(const os::LoadedLibrary& library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(os::find_function(library, name));
  return function != nullptr;
}

/// Returns the MuJoCo libraries of this process that can have plugins, in the order of their loading.
std::vector<os::LoadedLibrary> loaded_mujocos() {
  std::vector<os::LoadedLibrary> mujocos = os::loaded_libraries("libmujoco");
  std::erase_if(mujocos, [](const os::LoadedLibrary& library) {
    // A library that only needs MuJoCo also finds its functions.
    return os::file_of_function(os::find_function(library, "mj_versionString")) != library.file ||
           os::find_function(library, "mjp_registerPlugin") == nullptr;
  });
  return mujocos;
}

/// Returns the version of one of loaded_mujocos(), such as "4.0.1".
std::string version_of(const os::LoadedLibrary& mujoco) {
  const char* (*version)() = nullptr;
  return find(mujoco, "mj_versionString", version) ? version() : "?";
}

/// Forwards all calls to the functions of this library from now on. Returns the name of a function that the library
/// lacks, or an empty text.
std::string use_functions_of(const os::LoadedLibrary& mujoco) {
#define TAXEL_FIND(result, name, parameters, arguments) \
  if (!find(mujoco, #name, name##_in_process)) return #name;
  TAXEL_MUJOCO_FUNCTIONS(TAXEL_FIND)
#undef TAXEL_FIND
  if (!find(mujoco, "mju_warning", mju_warning_in_process)) return "mju_warning";
  if (!find(mujoco, "mju_error", mju_error_in_process)) return "mju_error";
  return "";
}

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

/// Returns true if another library of ours has registered a refusal with the MuJoCo that this library uses. MuJoCo
/// cannot replace a plugin.
bool is_refused() {
  const mjpPlugin* present = mjp_getPlugin(kPluginName, nullptr);
  return present != nullptr && present->copy == nullptr;  // the real plugin can copy its data
}

/// Registers `taxel.sensor` and `taxel.contact` with a MuJoCo of any version from 3.0 on, so that each scene that uses
/// them fails to compile with `reason` instead of "plugin not found". Gives `reason` as a warning at once. Does nothing
/// to plugins of these names that are registered already.
void register_refusal(const os::LoadedLibrary& mujoco, const std::string& reason) {
  const auto warn = function_of<decltype(&mju_warning)>(mujoco, "mju_warning");
  if (warn == nullptr || refused().size() == kMostRefused) return;
  refused().push_back({reason, warn});
  register_one(mujoco, kPluginName, kSensorKeys);
  register_one(mujoco, kContactPluginName, kContactKeys);
  warn("%s", reason.c_str());
}

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

/// Keeps samples on disk, unless the environment has a value that cannot be read, of which it warns.
void keep_samples() {
  try {
    keep_samples_on_disk();
  } catch (const Error& error) {
    mju_warning("taxel plugin: %s", error.what());
  }
}

using WarningHandler = void (*)(const char*);
WarningHandler (*handler_of_compilation)() = nullptr;

/// Makes warnings wait while MuJoCo 3.3.7 and 3.8.1 compile a scene: MjSpec.compile() of their Python raises an error
/// for each warning. While they compile, the thread has a handler of warnings; later versions have no such function.
void spare_compilations(const os::LoadedLibrary& mujoco) {
  if (find(mujoco, "_mjPRIVATE__get_tls_warning_fn", handler_of_compilation))
    delay_warnings_while([] { return handler_of_compilation() != nullptr; });
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
        spare_compilations(mujoco);
        keep_samples();
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
