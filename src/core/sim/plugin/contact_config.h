// The configuration of one `taxel.contact` instance, read from its MJCF keys (docs/plugin.md): soft contact between
// geoms without taxels.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <utility>
#include <vector>

#include "core/sim/plugin/sensor_config.h"

namespace taxel {

struct ContactConfig {
  std::string name;                     ///< name of the instance, for messages
  OtherMaterials materials;             ///< materials of geoms, by geom name
  std::vector<ContactSettings> bodies;  ///< the soft geoms without a sensor, ascending by geom
  /// Named pairs, the smaller geom first, ascending. If empty, all pairs of geoms that collide.
  std::vector<std::pair<int, int>> pairs;
  bool apply = true;           ///< forces move bodies; otherwise they are sensed only
  BristleSettings bristles;    ///< friction of the soft geoms
  std::vector<Output> output;  ///< outputs of each body, in the order of `bodies`
};

/// Reads and checks all keys. Throws Error whose place is the key if a geom does not exist or is named twice, a pair
/// has two rigid geoms, or there are materials but no soft geom.
ContactConfig read_contact_config(const mjModel& m, int instance);

/// Returns the length of the instance's part of `sensordata`. Like sensor_dimension(), it can be called while the model
/// is being built.
int contact_dimension(const mjModel& m, int instance);

}  // namespace taxel
