// Colour numbers for taxels: neighbours get different colours.
#pragma once

#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A number from 0 to colors - 1 for each taxel in layout order. Taxels are neighbours where the balls of their fields
/// meet. Greedy in layout order: taxel k gets k modulo `colors`, so the first ones are as they stand; where an earlier
/// neighbour has that, the next number that none has; where the neighbours have all, the number whose nearest owner is
/// farthest. Taxels added at the end change no other's number; the same bytes each time. `colors` > 0.
std::vector<int> color_fields(const Layout& layout, int colors);

}  // namespace taxel
