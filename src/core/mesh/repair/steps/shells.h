// Connected shells of a draft.
#pragma once

#include "core/mesh/query/self_intersection.h"
#include "core/mesh/repair/draft.h"

namespace taxel {

/// Shells: faces connected by shared points, numbered by their first face.
struct FaceShells {
  std::vector<std::vector<int>> faces;  ///< faces of each shell, ascending
  std::vector<int> of_face;
};
FaceShells find_shells(const Draft& draft);

/// Signed volume of some faces by the divergence theorem [m^3]: meaningful if they are a closed shell.
double volume_of(const Draft& draft, const std::vector<int>& faces);

/// Returns true if a surface cuts through itself in more than a thousandth of its faces, and in more than a few. Fewer
/// places are folds that a pressure field survives.
bool cuts_through_itself(const Draft& draft);
/// Returns true if `faces` faces with these intersections cut through themselves in as many places.
bool cuts_through_itself(const SelfIntersections& found, int faces);

}  // namespace taxel
