// The cut of a mesh with a plane, for section views.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns one segment for each face that intersects the plane through `point` with this normal (any length > 0), in
/// the order of faces. Each segment has the body on its left, seen against the normal. Segments of neighbouring faces
/// have ends that are equal bit by bit, so the cut of a closed mesh consists of closed loops. A vertex on the plane is
/// treated as above it: faces in the plane give no segment, but their neighbours do. O(n).
std::vector<std::pair<dvec3, dvec3>> slice_mesh(const TriMesh& mesh, const dvec3& point, const dvec3& normal);

}  // namespace taxel
