// Evens out samples on a surface by local farthest-point moves.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/layout/poisson_disk.h"
#include "core/mesh/closest_point.h"

namespace taxel {

/// Climbs from `start` to a local maximum of the distance to the nearest of `others`, a centre of an empty circle, and
/// stops at most about `reach` away. Never ends nearer to `others` than it began. `others` holds at least one point.
dvec2 climb_to_hole(const std::vector<dvec2>& others, const dvec2& start, double reach);

/// Moves each sample in turn to the largest hole beside it, in `sweeps` sweeps over all of them, as farthest-point
/// optimisation does (Schloemer, Heck, Deussen 2011), here in the tangent plane, back onto the surface, and only where
/// its distance to the nearest sample on the same wall truly grows. `spacing` is that of the densest packing [m].
/// Fills position, normal and face; same bytes on any number of threads. Throws Cancelled through `progress`.
void spread_samples(const MeshIndex& surface, double spacing, int sweeps, std::vector<SurfaceSample>& samples,
                    Progress* progress);

}  // namespace taxel
