// Repairs of one taxel or subtaxel.
#pragma once

#include <optional>

#include "core/base/error.h"
#include "core/document/fix.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Returns the repair of a problem whose pointer begins with /taxels, or nothing if no repair is known.
std::optional<Fix> fix_of_taxel(const Problem& problem, const Project& project, const MeshIndex* skin);

/// Returns the change that moves the taxel and its subtaxels to the nearest points of the skin and gives them the
/// smooth normals there. A taxel or subtaxel whose centre is not finite does not change.
TaxelChange projected(const Taxel& taxel, const MeshIndex& skin);

}  // namespace taxel
