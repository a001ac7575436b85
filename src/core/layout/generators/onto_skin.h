// Taxels whose places come from elsewhere (a table, a drawing), brought onto a skin.
#pragma once

#include <limits>
#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Each taxel at the nearest point of the skin, with the smooth normal there; its subtaxels too. Ids, names, radii and
/// order are kept. Throws Error("points", "taxel ID", ...) for one further than `farthest` [m] from the skin (its unit
/// may be another one), or not finite.
std::vector<Taxel> onto_skin(std::vector<Taxel> taxels, const MeshIndex& skin,
                             double farthest = std::numeric_limits<double>::infinity());

}  // namespace taxel
