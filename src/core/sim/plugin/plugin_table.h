// The MuJoCo engine plugins `taxel.sensor` and `taxel.contact`: PASSIVE applies the contact forces, SENSOR fills the
// readings.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/sim/plugin/contact_instance.h"
#include "core/sim/plugin/hydro_instance.h"

namespace taxel {

inline constexpr const char* kPluginName = "taxel.sensor";
inline constexpr const char* kContactPluginName = "taxel.contact";

/// Registers both plugins with MuJoCo, once. Returns false when another library of this process has registered its own
/// copies (the plugin module): then those are used, and find_sensor() must not be.
bool register_sensor_plugin();

/// The sensor of instance `instance` in `d`; null when it is not one of ours, or when `d` is a bitwise copy (as
/// pickling makes) whose sensors live in another mjData.
HydroInstance* find_sensor(const mjData& d, int instance);

/// The sensor of instance `instance`, one of ours, in `d`; made first where `d` is such a copy. Throws Error.
HydroInstance& own_sensor(const mjModel& m, mjData& d, int instance);

/// A declared body in `d`, as find_sensor() and own_sensor() treat sensors.
BodyContacts* find_body(const mjData& d, BodyId id);
BodyContacts& own_body(const mjModel& m, mjData& d, BodyId id);

/// Instances in the model, ascending: of `taxel.sensor`, and of `taxel.contact`.
std::vector<int> sensor_instances(const mjModel& m);
std::vector<int> contact_instances(const mjModel& m);

}  // namespace taxel
