// The contacts of collision geoms within the skins of added sensors, which the skins replace.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A sensor that is added to a scene.
struct AddedSensor {
  std::string instance, geom, keys;          ///< `keys` are more plugin keys, as MJCF
  SensorModelPtr model;                      ///< model; null until the scene is known, for layouts of other programs
  const SceneAttachment* foreign = nullptr;  ///< request for a layout of another program, or null
  ImportedLayout imported = {};
  bool keeps_sisters = false;  ///< SceneAttachment::keeps_sisters
};

/// Returns the collision geoms within the skins of the added sensors, each with the geom of its sensor, and adds notes
/// that name them. The geoms that such a sister can touch must all be touched by the skin: otherwise the sister
/// remains.
std::map<int, int> replaced_sisters(const mjModel& m, std::vector<AddedSensor>& added, std::vector<std::string>& notes);

/// Lists the touched geoms of each added sensor in its keys, because they cannot be found without the contacts of the
/// sisters. There, a sister is replaced by the geom of its sensor.
void list_others(const mjModel& m, const std::map<int, int>& sisters, std::vector<AddedSensor>& added);

}  // namespace taxel
