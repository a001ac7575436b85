// Overlap of the receptive fields of two taxels, as the overlap of their discs.
#pragma once

#include <cstddef>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Two taxels that share more than this part of the larger disc read nearly the same.
inline constexpr double kLargeOverlap = 0.8;

/// Area that two discs in one plane share, as a part of the area of the larger one: 0 to 1. Radii > 0, distance of the
/// centres >= 0, all in the same unit. The shared part is two circular segments; see Weisstein, "Circle-Circle
/// Intersection", MathWorld.
double disc_overlap(double radius, double other_radius, double distance);

struct OverlappingTaxels {
  std::size_t taxel = 0, earlier = 0;  ///< indices; earlier < taxel
  double part = 0;                     ///< disc_overlap of the two
};

/// For each taxel that shares more than `least` (at least 0.5) with an earlier one, the first such. Taxels at the
/// same place, or whose normals are more than 45 degrees apart, are not compared. In the order of the taxels.
std::vector<OverlappingTaxels> overlapping_taxels(const std::vector<Taxel>& taxels, double least = kLargeOverlap);

}  // namespace taxel
