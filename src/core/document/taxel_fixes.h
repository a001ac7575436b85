// Repairs of one taxel or subtaxel; fix_for (fixes.h) asks for them.
#pragma once

#include "core/document/fixes.h"

namespace taxel {

/// Of a problem that points into /taxels; nothing where none fits.
std::optional<Fix> fix_of_taxel(const Problem& problem, const Project& project, const MeshIndex* skin);

}  // namespace taxel
