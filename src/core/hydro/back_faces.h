// Leaves back faces out of contact surfaces (kernel/front_weight.h).
#pragma once

#include <span>

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"

namespace taxel {

/// Multiplies the pressure of each polygon by its factors for the soft bodies whose material asks for it, and moves
/// polygons without pressure to those that are left out, with the reason back_face. X_AB is the pose of b in a.
/// `slopes` are those of the last polygons, which two soft bodies have beyond their tets (DepthWorkspace::slopes).
void leave_out_back_faces(const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB,
                          std::span<const double> slopes, ContactSurface& surface);

}  // namespace taxel
