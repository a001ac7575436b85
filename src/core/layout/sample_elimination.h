// Weighted sample elimination (Yuksel 2015, "Sample Elimination for Generating Poisson Disk Sample Sets").
#pragma once

#include "core/base/progress.h"
#include "core/layout/surface_pool.h"

namespace taxel {

/// Whether two points lie on the same wall: normals more than 90 degrees apart belong to opposite sides of a thin part,
/// and their distance through it says nothing about evenness.
inline bool same_wall(const dvec3& normal_a, const dvec3& normal_b) {
  const double right_angle = -1e-9;  // a cosine of 0 with rounding: faces of a box that meet at an edge are one wall
  return glm::dot(normal_a, normal_b) > right_angle;
}

/// Numbers of the `count` pool points that stay, ascending, when the most crowded point is taken away again and again.
/// `area` is that of the sampled surface. Throws Cancelled through `progress`.
std::vector<int> eliminate_samples(const SurfacePool& pool, int count, double area, Progress* progress);

}  // namespace taxel
