// Repair of the mesh of a soft body that is not a sensor.
#pragma once

#include <string>

#include "core/hydro/hydro_body.h"
#include "core/mesh/repair/repair.h"

namespace taxel {

/// Repairs the mesh of a soft shape by the default recipe. face_numbers remain those of the faces before the repair,
/// with -1 for filled faces. Rigid shapes and shapes that are not a mesh do not change. Returns the repaired mesh with
/// its report, or null if nothing was changed. Throws Error as repair_mesh() does.
RepairedMeshPtr repair_soft_mesh(Shape& shape, const Material& material);

}  // namespace taxel
