// The MuJoCo engine plugin `taxel.sensor`: PASSIVE applies the contact forces, SENSOR fills the readings.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/sim/plugin/hydro_instance.h"

namespace taxel {

inline constexpr const char* kPluginName = "taxel.sensor";

/// Registers the plugin with MuJoCo, once. Returns false when another library of this process has registered its own
/// copy (the plugin module): then that one is used, and find_sensor() must not be.
bool register_sensor_plugin();

/// The sensor of instance `instance` in `d`; null when it is not one of ours, or when `d` is a bitwise copy (as
/// pickling makes) whose sensors live in another mjData.
HydroInstance* find_sensor(const mjData& d, int instance);

/// The sensor of instance `instance`, one of ours, in `d`; made first where `d` is such a copy. Throws Error.
HydroInstance& own_sensor(const mjModel& m, mjData& d, int instance);

/// Instances of `taxel.sensor` in the model, ascending.
std::vector<int> sensor_instances(const mjModel& m);

}  // namespace taxel
