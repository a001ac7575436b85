// Weighted sample elimination (Yuksel 2015, "Sample Elimination for Generating Poisson Disk Sample Sets").
#pragma once

#include "core/base/progress.h"
#include "core/layout/sampling/surface_pool.h"
#include "core/layout/sampling/surface_walk.h"

namespace taxel {

/// Numbers of the `count` pool points that stay, ascending, when the most crowded point is taken away again and again.
/// Distances are straight lines on one patch and unfolded ones elsewhere. Throws Cancelled through `progress`.
std::vector<int> eliminate_samples(const SurfaceGraph& surface, const SurfacePool& pool, int count, Progress* progress);

}  // namespace taxel
