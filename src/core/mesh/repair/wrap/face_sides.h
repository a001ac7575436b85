// The sides of the faces of a broken surface: which of them are inside of a body.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/repair/wrap/winding_number.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

enum class FaceSides : char {
  skin,          ///< the body is behind the face and ends there
  both_inside,   ///< a wall within the body
  both_outside,  ///< a face that winds around nothing
  unknown        ///< faces cross or end here: the winding number of each point decides
};

/// Finds the sides of all faces; `crossing` are the pairs of faces that cross each other. Between crossing faces and
/// rims the winding number on a side of the surface is constant if the surface is closed, so one face answers for all
/// that are connected to it; if it has rims, the mean of some faces does. O(n log n).
std::vector<FaceSides> find_face_sides(const TriMesh& mesh, const std::vector<std::pair<int, int>>& crossing,
                                       const WindingNumber& winding);

}  // namespace taxel
