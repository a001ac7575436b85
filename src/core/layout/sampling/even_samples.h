// Even samples on a surface: weighted sample elimination (Yuksel 2015, "Sample Elimination for Generating Poisson Disk
// Sample Sets"), and local farthest-point moves, which even out samples.
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/layout/sampling/surface_walk.h"

namespace taxel {

/// Removes the most crowded point of the pool repeatedly, until `count` points remain, and returns their indices,
/// ascending. Points closer than `spacing`, that of the densest packing of `count` points [m], crowd each other.
/// Distances are straight on one patch and unfolded elsewhere. Throws Cancelled through `progress`.
std::vector<int> eliminate_samples(const SurfaceGraph& surface, const SurfacePool& pool, int count, double spacing,
                                   Progress* progress);

/// Returns true for the places to which samples may move.
using IsAllowed = std::function<bool(const dvec3&)>;

/// Moves each sample in turn to the largest hole next to it, in `sweeps` sweeps over all samples, as farthest-point
/// optimisation does (Schloemer, Heck, Deussen 2011), here in the tangent plane, or where the surface bends sharply in
/// the unfolded surface; along the surface, and only where the distance to the nearest sample truly grows. That keeps
/// samples apart, but leaves a few gaps: a last sweep moves those with the widest cells to the centroids of these, no
/// nearer to any other than 0.86 spacings, or than they are. `spacing` is that of the densest packing [m]. Position,
/// normal and face of a sample stay together. The result has the same bytes for any number of threads. Throws Cancelled
/// through `progress`.
///
/// If `is_allowed` is set, samples move only to places for which it returns true. Several threads call it at once.
void spread_samples(const SurfaceGraph& surface, double spacing, int sweeps, std::vector<SurfaceSample>& samples,
                    Progress* progress, const IsAllowed& is_allowed = nullptr);

}  // namespace taxel
