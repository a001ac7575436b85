// Mass properties of a solid body of even density.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct Inertia {
  double mass = 0;  ///< [kg]
  dvec3 center{0};  ///< of mass, frame of the mesh [m]
  dmat3 moment{0};  ///< about the centre, axes of the mesh [kg m^2]
};

/// The space inside a closed mesh, filled evenly to `mass`; of a mesh that encloses no volume, its bounding box.
Inertia solid_inertia(const TriMesh& mesh, double mass);

}  // namespace taxel
