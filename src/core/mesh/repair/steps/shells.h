// Connected shells of a draft.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/query/box_tree.h"
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

/// Some faces with the points that they use, in the order of the draft.
Draft extract_faces(const Draft& draft, const std::vector<int>& faces);
/// Appends all points and faces of another draft.
void append(Draft& draft, const Draft& other);

/// A tree over the boxes of the faces, for few queries.
BoxTree tree_of_faces(const Draft& draft);

/// Pairs of faces that cut through each other (self_intersection.h), the first one lower, ascending.
std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft);
/// The pairs of which at least one face is chosen: a nonzero entry.
std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft, const std::vector<char>& chosen);

/// The largest number of pairs of faces that cut through each other that a pressure field bears: three, or a thousandth
/// of the faces.
int few_pairs(int faces);

}  // namespace taxel
