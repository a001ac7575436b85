// The content of a geom's surface. Geoms with equal content share all that is built from it.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>

namespace taxel {

/// Returns a hash of all that determines the surface of a geom, frame G, and the frame of its mesh file: type, sizes
/// and asset. Returns nothing for a signed distance function of a plugin, whose content is not in the model.
std::optional<std::string> geom_content(const mjModel& m, int geom);

}  // namespace taxel
