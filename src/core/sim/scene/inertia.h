// Mass properties of a solid body of uniform density.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct Inertia {
  double mass = 0;  ///< [kg]
  dvec3 center{0};  ///< centre of mass, frame of the mesh [m]
  dmat3 moment{0};  ///< moment of inertia about the centre of mass, axes of the mesh [kg m^2]
};

/// Returns the mass properties of a closed mesh filled uniformly to `mass`. A mesh without volume is replaced by its
/// bounding box.
Inertia solid_inertia(const TriMesh& mesh, double mass);

}  // namespace taxel
