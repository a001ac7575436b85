// Neighbouring receptive fields: the overlap of two taxels as that of their discs, and colours that differ between
// neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Fraction of the larger disc above which two taxels that share it read nearly the same.
inline constexpr double kLargeOverlap = 0.8;

/// Returns the area that two discs in one plane share, as a fraction of the area of the larger one, 0 to 1. Radii > 0,
/// distance of the centres >= 0, all in the same unit. The shared part is two circular segments; see Weisstein,
/// "Circle-Circle Intersection", MathWorld.
double disc_overlap(double radius, double other_radius, double distance);

struct OverlappingTaxels {
  std::size_t taxel = 0, earlier = 0;  ///< indices; earlier < taxel
  double part = 0;                     ///< disc_overlap of the two
};

/// Returns, in the order of the taxels, each taxel that shares more than `least` (at least 0.5) with an earlier taxel,
/// together with the first such taxel. Taxels at the same place, or with normals more than 45 degrees apart, are not
/// compared.
std::vector<OverlappingTaxels> overlapping_taxels(const std::vector<Taxel>& taxels, double least = kLargeOverlap);

/// Assigns colours: returns a number from 0 to colors - 1 for each taxel in layout order. Taxels are neighbours if the
/// balls of their fields intersect. The assignment is greedy in layout order: taxel k gets k modulo `colors`, unless an
/// earlier neighbour has this number; then it gets the next number that no neighbour has. If the neighbours have all
/// numbers, it gets the number whose nearest owner is farthest. Taxels that are added at the end do not change the
/// numbers of others. Deterministic. `colors` > 0.
std::vector<int> color_fields(const Layout& layout, int colors);

}  // namespace taxel
