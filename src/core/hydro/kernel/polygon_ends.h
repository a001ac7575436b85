// The edges at which the polygon of a tet ends the part of a plane that the tets cover.
#pragma once

#include <span>

#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/plane/covered_region.h"

namespace taxel {

/// Returns the edges of a tet's polygon that are on faces of the tet without a neighbour. The vertices x are in the
/// frame of the tets [m].
CoveredRegion::Ends ends_of(const PackedTet& tet, std::span<const dvec3> x);

}  // namespace taxel
