// Cuts faces that cross each other out of a shell and fills the holes.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/repair/draft.h"

namespace taxel {

/// Removes the crossing faces of one closed shell, fills the holes and, as long as faces still cross, removes one more
/// ring of faces there. `pairs` are those of find_crossing_pairs(). Succeeds if the shell is then closed, at most
/// `allowed` pairs of faces cross, at most a tenth of its area is replaced, and new faces are within two edges of a
/// wrap of the old ones, as are old faces outside of the new shell. Otherwise `shell` remains as it was. Other faces
/// keep their points, bit for bit. New faces are marked kFilledFace. `step` counts the filled holes and the removed
/// faces. O(n log n) for n faces.
bool cut_crossings(Draft& shell, const std::vector<std::pair<int, int>>& pairs, std::size_t allowed,
                   const RepairLimits& limits, RepairStep& step);

}  // namespace taxel
