// A geom of a model as the contact kernel sees it.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/sim/plugin/sensor_config.h"

namespace taxel {

/// The geom's body in the geom's own frame, made of the material that `materials` names it, otherwise rigid with the
/// geom's own sliding friction. A soft mesh that is not closed is repaired as a layout's mesh is by default; A
/// sentence on each change is added to `notes`. Throws Error that names the geom.
HydroBodyPtr geom_body(const mjModel& m, int geom, const OtherMaterials& materials, std::vector<std::string>& notes);

}  // namespace taxel
