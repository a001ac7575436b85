// Moves taxels from another source (a table, a drawing) onto a skin.
#pragma once

#include <limits>
#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns the taxels and their subtaxels at the nearest points of the skin, with the smooth normals there. Ids, names,
/// radii and order are unchanged. Throws Error("points", "taxel ID", ...) for a taxel that is farther than `farthest`
/// [m] from the skin (its unit may be wrong), or not finite.
std::vector<Taxel> onto_skin(std::vector<Taxel> taxels, const MeshIndex& skin,
                             double farthest = std::numeric_limits<double>::infinity());

}  // namespace taxel
