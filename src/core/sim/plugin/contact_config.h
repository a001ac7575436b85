// The configuration of one `taxel.contact` instance, as the MJCF says it (docs/plugin.md lists the keys): soft contact
// between geoms without taxels.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <utility>
#include <vector>

#include "core/sim/plugin/sensor_config.h"

namespace taxel {

struct ContactConfig {
  std::string name;                        ///< name of the instance, for messages
  OtherMaterials materials;                ///< by geom name
  std::vector<ContactSettings> bodies;     ///< the soft geoms without a sensor, ascending by geom
  std::vector<std::pair<int, int>> pairs;  ///< named pairs, the smaller geom first, ascending; empty: all that collide
  bool apply = true;                       ///< forces move bodies; otherwise they are sensed only
  std::vector<Output> output;              ///< outputs of each body, in the order of `bodies`
};

/// Reads and checks all keys. Throws Error whose place is the key: a geom that does not exist or is named twice, a pair
/// of rigid geoms, materials without a soft geom.
ContactConfig read_contact_config(const mjModel& m, int instance);

/// Length of the instance's part of `sensordata`; callable while the model is being built, as sensor_dimension().
int contact_dimension(const mjModel& m, int instance);

}  // namespace taxel
