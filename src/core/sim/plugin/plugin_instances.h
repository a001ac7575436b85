// The instances of the plugins `taxel.sensor` and `taxel.contact` in a model.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace taxel {

inline constexpr const char* kPluginName = "taxel.sensor";
inline constexpr const char* kContactPluginName = "taxel.contact";

/// The configuration keys of each plugin. MuJoCo refuses any other key.
inline constexpr const char* kSensorKeys[] = {
    "layout",  "geom", "others", "other_ids", "materials", "force", "output", "taxels", "tangential_stiffness",
    "bristles"};
inline constexpr const char* kContactKeys[] = {"materials", "pairs", "geoms", "force", "output", "tangential_stiffness",
                                               "bristles"};

/// Returns true if the plugin of a slot is registered and has that name.
bool is_plugin(int slot, const char* name);

/// Returns the instances of `taxel.sensor`, ascending.
std::vector<int> sensor_instances(const mjModel& m);
/// Returns the instances of `taxel.contact`, ascending.
std::vector<int> contact_instances(const mjModel& m);

}  // namespace taxel
