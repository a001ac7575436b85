// Weighted sample elimination (Yuksel 2015, "Sample Elimination for Generating Poisson Disk Sample Sets").
#pragma once

#include "core/base/progress.h"
#include "core/layout/sampling/surface_pool.h"
#include "core/layout/sampling/surface_walk.h"

namespace taxel {

/// Whether the straight line between two points of a surface stands for their distance along it: a patch that bends by
/// at most a right angle between them, and does not rise by more than 30 degrees and that bend. Not so over a sharper
/// edge, through a thin wall, or from sheet to sheet of a stack.
inline bool on_one_patch(const dvec3& normal_a, const dvec3& normal_b, const dvec3& apart) {
  const double right_angle = -1e-9;  // a cosine of 0 with rounding: faces of a box that meet at an edge are one patch
  const double cosine = glm::dot(normal_a, normal_b), rise_a = glm::dot(normal_a, apart),
               rise_b = glm::dot(normal_b, apart);
  const double steepest = 1.5 - cosine;  // at least sin(30 degrees + bend), up to 1, where all is allowed
  return cosine > right_angle &&
         std::max(rise_a * rise_a, rise_b * rise_b) <= steepest * steepest * glm::dot(apart, apart);
}

/// Numbers of the `count` pool points that stay, ascending, when the most crowded point is taken away again and again.
/// Distances are straight lines on one patch and unfolded ones elsewhere. Throws Cancelled through `progress`.
std::vector<int> eliminate_samples(const SurfaceGraph& surface, const SurfacePool& pool, int count, Progress* progress);

}  // namespace taxel
