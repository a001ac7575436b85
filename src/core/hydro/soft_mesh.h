// The mesh of a soft body that is no sensor: repaired, because it comes from a file that nobody looked at.
#pragma once

#include <string>

#include "core/hydro/hydro_body.h"
#include "core/mesh/repair/repair.h"

namespace taxel {

/// Repairs the mesh of a shape that is to be soft by the default recipe; face_numbers stay those of the faces that the
/// shape came with, -1 for faces that were filled in. Shapes that are no mesh and rigid ones stay as they are. Returns
/// what was changed, null if nothing was. Throws Error as repair_mesh() does.
RepairedMeshPtr repair_soft_mesh(Shape& shape, const Material& material);

}  // namespace taxel
