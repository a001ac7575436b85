// Repair of the mesh of a soft body that is no sensor, which may come from any file.
#pragma once

#include <string>

#include "core/hydro/hydro_body.h"
#include "core/mesh/repair/repair.h"

namespace taxel {

/// Repairs the mesh of a shape that is to be soft, by the default recipe. face_numbers remain those of the faces before
/// the repair, -1 for faces that were filled in. Rigid shapes and shapes that are no mesh stay as they are. Returns the
/// repaired mesh with its report, or null if nothing was changed. Throws Error as repair_mesh() does.
RepairedMeshPtr repair_soft_mesh(Shape& shape, const Material& material);

}  // namespace taxel
