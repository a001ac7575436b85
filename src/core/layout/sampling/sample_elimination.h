// Weighted sample elimination (Yuksel 2015, "Sample Elimination for Generating Poisson Disk Sample Sets").
#pragma once

#include "core/base/progress.h"
#include "core/layout/sampling/surface_pool.h"
#include "core/layout/sampling/surface_walk.h"

namespace taxel {

/// Removes the most crowded point of the pool repeatedly, until `count` points remain, and returns their indices,
/// ascending. Points closer than `spacing`, that of the densest packing of `count` points [m], crowd each other.
/// Distances are straight on one patch and unfolded elsewhere. Throws Cancelled through `progress`.
std::vector<int> eliminate_samples(const SurfaceGraph& surface, const SurfacePool& pool, int count, double spacing,
                                   Progress* progress);

}  // namespace taxel
