// The contact surface of two bodies at given poses.
#pragma once

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/kernel/workspace.h"

namespace taxel {

/// Fills `out` (frame of A; normals push A), with at least one soft body; both may be. Half-open faces: what lies
/// exactly between two tets is counted once. Throws Error naming the bodies when both are rigid, or both half-spaces,
/// or a pose is not finite or has no unit quaternion.
void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace);

}  // namespace taxel
