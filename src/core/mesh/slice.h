// The cut of a mesh with a plane, for section views.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// One segment for each face that the plane through `point` at right angles to `normal` (any length > 0) passes
/// through. Each runs with the body on its left, seen against the normal; the ends of neighbouring faces are equal bit
/// by bit, so the cut of a closed mesh is made of closed loops. A vertex on the plane counts as above it: faces in the
/// plane give no segment, their neighbours do. Order of faces. O(n).
std::vector<std::pair<dvec3, dvec3>> slice_mesh(const TriMesh& mesh, const dvec3& point, const dvec3& normal);

}  // namespace taxel
