// Computes the contact surface of two bodies at given poses.
#pragma once

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"

namespace taxel {

struct IntersectWorkspace;

/// Fills `out` (frame of A; normals push A). At least one body must be soft. Faces of tets are half-open, so a point
/// exactly between two tets counts once. Throws Error naming the bodies if both are rigid or both are half-spaces, or
/// if a pose is not finite or its quaternion is not of unit length.
void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace);

}  // namespace taxel
