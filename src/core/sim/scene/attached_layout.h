// Layouts of other programs on the geoms of a scene: the file names the geom, the geom gives mesh and material.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "core/layout/file/layout_format.h"
#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Reads the layout of an attachment: the sensor that is asked for, otherwise the one on the attachment's geom,
/// otherwise the first. Throws Error naming file and place.
ImportedLayout read_attached_layout(const SceneAttachment& attachment);

/// Puts the layout on the mesh that is chosen, otherwise on that of the geom, and compiles it. A field "cs::GEOM" of
/// the scene gives the material. Adds values that were not in the file to `notes`. Throws Error naming file and place:
/// no such geom, or one whose shape is neither a mesh file nor a box.
SensorModelPtr compile_attached_layout(const SceneAttachment& attachment, ImportedLayout imported,
                                       const std::string& geom, const mjModel& scene, std::vector<std::string>& notes);

}  // namespace taxel
