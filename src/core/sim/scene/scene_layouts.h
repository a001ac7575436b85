// The layouts of a MuJoCo scene: of the plugin, of touch sites, and of MuJoCo's own tactile sensors.
#pragma once

#include <filesystem>
#include <vector>

#include "core/layout/file/imported_layout.h"

namespace taxel {

/// Returns the layouts of a scene and of the files that it includes. Those of the plugin are read from the text. If
/// there are <touch> or <tactile> sensors, the scene is compiled, so that classes, frames, angles and MuJoCo's own
/// shapes count: one layout for each body with touch sites, and one for each tactile sensor, with a taxel at each
/// vertex of its mesh. Positions are in the frame of the mesh file of the body's only mesh geom or of the sensor's
/// geom, otherwise in that of the body. Throws Error naming the file: it cannot be read, MuJoCo cannot compile it, or
/// there is no layout.
std::vector<ImportedLayout> read_scene_layouts(const std::filesystem::path& scene);

}  // namespace taxel
