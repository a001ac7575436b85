// Layouts of other programs on the geoms of a scene. The file names the geom; the geom gives the mesh and the material.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "core/layout/formats/format_table.h"
#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Reads the layout of an attachment. If the file has several sensors, it is the requested one, otherwise the one on
/// the geom of the attachment, otherwise the first. Throws Error naming file and place.
ImportedLayout read_attached_layout(const SceneAttachment& attachment);

/// Places the layout on the mesh of the attachment, or on the mesh of the geom if the attachment has none, and compiles
/// the layout. A field "cs::GEOM" of the scene gives the material. Adds a note for each value that is not in the file.
/// Throws Error naming file and place if there is no such geom, or its shape is neither a mesh file nor a box.
SensorModelPtr compile_attached_layout(const SceneAttachment& attachment, ImportedLayout imported,
                                       const std::string& geom, const mjModel& scene, std::vector<std::string>& notes);

}  // namespace taxel
