// The surface where a function of space is zero, as a closed mesh.
#pragma once

#include <functional>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Marching tetrahedra (Doi, Koide 1991) on a grid of cubes of at most `edge`, six tets each (Kuhn 1960), over `box`
/// and one cube beyond. `distance` is negative inside; vertices are at its zeros along the edges of the grid, at least
/// a thousandth of an edge away from their ends. The mesh is closed and oriented outward. Throws Error if no value in
/// the box is negative, if one at the rim of the grid is (the box is too small), if a value is not finite, or if the
/// edge is not positive or too short for the box.
TriMesh make_level_set(const std::function<double(const dvec3&)>& distance, const Aabb& box, double edge);

}  // namespace taxel
