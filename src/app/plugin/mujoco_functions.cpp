#include "app/plugin/mujoco_functions.h"

#include <mujoco/mujoco.h>

#include <cstdarg>
#include <cstdio>

// Each function of MuJoCo that the plugin calls: result, name, parameters, arguments. A function that is not listed is
// an undefined symbol when the library is linked.
#define TAXEL_MUJOCO_FUNCTIONS(F)                                                                                    \
  F(void, mj_applyFT,                                                                                                \
    (const mjModel* m, mjData* d, const mjtNum force[3], const mjtNum torque[3], const mjtNum point[3], int body,    \
     mjtNum* qfrc_target),                                                                                           \
    (m, d, force, torque, point, body, qfrc_target))                                                                 \
  F(void, mj_contactForce, (const mjModel* m, const mjData* d, int id, mjtNum result[6]), (m, d, id, result))        \
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

}  // namespace

std::vector<os::LoadedLibrary> loaded_mujocos() {
  std::vector<os::LoadedLibrary> mujocos = os::loaded_libraries("libmujoco");
  std::erase_if(mujocos, [](const os::LoadedLibrary& library) {
    // A library that only needs MuJoCo also finds its functions.
    return os::file_of_function(os::find_function(library, "mj_versionString")) != library.file ||
           os::find_function(library, "mjp_registerPlugin") == nullptr;
  });
  return mujocos;
}

std::string version_of(const os::LoadedLibrary& mujoco) {
  const char* (*version)() = nullptr;
  return find(mujoco, "mj_versionString", version) ? version() : "?";
}

std::string use_functions_of(const os::LoadedLibrary& mujoco) {
#define TAXEL_FIND(result, name, parameters, arguments) \
  if (!find(mujoco, #name, name##_in_process)) return #name;
  TAXEL_MUJOCO_FUNCTIONS(TAXEL_FIND)
#undef TAXEL_FIND
  if (!find(mujoco, "mju_warning", mju_warning_in_process)) return "mju_warning";
  if (!find(mujoco, "mju_error", mju_error_in_process)) return "mju_error";
  return "";
}

}  // namespace taxel
