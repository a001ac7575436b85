// Wraps: a new surface around faces that no exact step makes into a solid.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/repair/wrap/wrap_field.h"

namespace taxel {

/// Appends to `result` a closed surface around the faces of `source`, which has no other points: the level set of
/// WrapField at `limits.edge`, moved onto the faces if these are near, and simplified by `limits.tolerance`. Cavities
/// are filled, and parts smaller than an edge are dropped. The new faces are marked kWrappedFace. The result does not
/// depend on the unit of length. Throws Error that names /mesh/repair/edge if the lattice would be too large.
void wrap_faces(Draft& result, const Draft& source, WrapKind kind, const RepairLimits& limits, Progress* progress);

}  // namespace taxel
