// The MuJoCo engine plugins `taxel.sensor` and `taxel.contact`: PASSIVE applies the contact forces, SENSOR fills the
// readings.
#pragma once

#include <mujoco/mujoco.h>

#include "core/sim/plugin/pairs/declared_bodies.h"
#include "core/sim/plugin/plugin_data.h"
#include "core/sim/plugin/plugin_instances.h"

namespace taxel {

/// Registers both plugins with MuJoCo, once. Returns false if another library of this process, such as the plugin
/// module, has already registered its own copies. Then MuJoCo uses those copies, and find_sensor() must not be called.
bool register_sensor_plugin();

/// Sets a function that returns true while warnings about a scene wait. Warnings of a new mjData then come with the
/// next one, and others with the next step; messages of errors never wait. Without a function, or with null, none
/// waits.
void delay_warnings_while(bool (*waits)());

/// Returns the sensor of an instance in `d`. Returns null if the instance is not of this library, or if `d` is a
/// bitwise copy (as pickling makes) whose sensors are in another mjData.
HydroInstance* find_sensor(const mjData& d, int instance);

}  // namespace taxel
