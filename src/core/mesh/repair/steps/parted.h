// Which sides of an edge belong together, also where more than two faces meet.
#pragma once

#include "core/mesh/repair/topology.h"

namespace taxel {

/// Pairs of sides between which solid lies: the two of a plain edge, and those of an edge of more faces by their angles
/// around it. Sides that wind alike, or that are too many, stay without a partner.
std::vector<SidePair> pair_sides(const Draft& draft, std::span<const EdgeSide> sides);

}  // namespace taxel
