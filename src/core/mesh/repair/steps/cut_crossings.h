// Cuts faces that cross each other out of a shell and fills the holes.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/repair/steps/shells.h"

namespace taxel {

/// Removes the crossing faces of one closed shell, fills the holes and, as long as faces still cross, removes one more
/// ring of faces there. `pairs` are those of find_crossing_pairs(). Succeeds if the shell is then closed, at most
/// `allowed` pairs of faces cross, at most a tenth of its area is replaced, and new faces are within two edges of a
/// wrap of the old ones, as are old faces outside of the new shell. Otherwise `shell` remains as it was. Other faces
/// keep their points, bit for bit. New faces are marked kFilledFace. `step` counts the filled holes and the removed
/// faces. O(n log n) for n faces.
bool cut_crossings(Draft& shell, const std::vector<std::pair<int, int>>& pairs, std::size_t allowed,
                   const RepairLimits& limits, RepairStep& step);

/// The crossings of faces of the same shell.
struct OwnCrossings {
  std::vector<std::vector<std::pair<int, int>>> pairs;  ///< pairs of each shell, ascending; empty if it is hopeless
  /// A nonzero entry for each shell with more than a few pairs, on too much of its area to be cut out.
  std::vector<char> is_hopeless;
  int count = -1;  ///< number of all pairs, also of different shells, or -1 if not all are known

  /// The number of all pairs of the draft, which are searched if not all are known.
  [[nodiscard]] int count_all(const Draft& draft) const;
};
/// Finds the crossings within the shells of a draft. Only if most faces cross others some shells are hopeless: a list
/// of all pairs would take long there.
OwnCrossings find_own_crossings(const Draft& draft, const FaceShells& shells);

}  // namespace taxel
