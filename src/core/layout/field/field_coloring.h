// Assigns colour numbers to taxels, so that neighbours have different colours.
#pragma once

#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Returns a number from 0 to colors - 1 for each taxel in layout order. Taxels are neighbours if the balls of their
/// fields intersect. The assignment is greedy in layout order: taxel k gets k modulo `colors`, unless an earlier
/// neighbour has this number; then it gets the next number that no neighbour has. If the neighbours have all numbers,
/// it gets the number whose nearest owner is farthest. Taxels that are added at the end do not change the numbers of
/// others. Deterministic. `colors` > 0.
std::vector<int> color_fields(const Layout& layout, int colors);

}  // namespace taxel
