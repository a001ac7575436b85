// The contact surface of two sensors, from poses alone.
#pragma once

#include "core/sim/plugin/hydro_instance.h"

namespace taxel {

/// As the one of the two finds it that computes the pair: `other` where it is mirrored (PairRole). X_WM, X_WO: of the
/// frames of the mesh files; `out` in that of `self`.
void intersect_sensors(const HydroInstance& self, const HydroInstance& other, bool mirrored, const Pose& X_WM,
                       const Pose& X_WO, ContactSurface& out, IntersectWorkspace& workspace);

}  // namespace taxel
