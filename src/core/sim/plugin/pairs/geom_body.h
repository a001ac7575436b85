// Builds the body that the contact kernel uses for a geom of a model.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/sim/plugin/plugin_config.h"

namespace taxel {

/// Returns a hash of all that determines the surface of a geom, frame G, and the frame of its mesh file: type, sizes
/// and asset. Geoms with equal content share all that is built from it. Returns nothing for a signed distance function
/// of a plugin, whose content is not in the model.
std::optional<std::string> geom_content(const mjModel& m, int geom);

/// Returns the shape of which geom_body() makes the body of a geom: with the length of edges of its material, and
/// repaired if it is a mesh. Throws Error that names the geom.
Shape geom_body_shape(const mjModel& m, int geom, const OtherMaterials& materials);

/// Returns the body of a geom, in the geom's own frame. Its material is that of `materials`; a geom without one is
/// rigid, with its own sliding friction. A mesh is repaired by repair_touched_mesh(); `repair` becomes a sentence on
/// the changes, empty if there are none. Throws Error that names the geom.
HydroBodyPtr geom_body(const mjModel& m, int geom, const OtherMaterials& materials, std::string& repair);

}  // namespace taxel
