// Repair of the meshes of bodies that a skin touches, and of soft bodies that are not a sensor.
#pragma once

#include <string>

#include "core/hydro/hydro_body.h"
#include "core/mesh/repair/repair.h"

namespace taxel {

/// Repairs the mesh of a shape that a skin touches. A soft mesh is repaired by the default
/// recipe of layouts, which may wrap it, a rigid one by exact steps alone; an open sheet without an inside becomes
/// two-sided if it is rigid. `exact` never wraps, and `off` changes nothing. face_numbers remain those of the faces
/// before the repair, with -1 for filled faces. Shapes that are not a mesh, height fields and signed distance functions
/// do not change. Returns the repaired mesh with its report, or null if nothing was changed. Throws Error with the
/// place and the remedy if no inside is found.
RepairedMeshPtr repair_touched_mesh(Shape& shape, const Material& material, TouchedRepair repair);

}  // namespace taxel
