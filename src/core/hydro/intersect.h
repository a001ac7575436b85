// The contact surface of two bodies at given poses.
#pragma once

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"

namespace taxel {

/// Memory that a caller keeps between calls, so that no step allocates after warm-up. One per thread.
struct IntersectWorkspace {
  std::vector<int> faces;  ///< of the rigid mesh, that may meet the soft body
};

/// Fills `out` (frame of A; normals push A) for exactly one soft and one rigid body, in either order.
/// Half-open faces: what lies exactly between two tets is counted once. Throws Error naming the bodies when both are
/// rigid or both soft.
void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace);

}  // namespace taxel
