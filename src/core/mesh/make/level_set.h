// The surface where a function of space is zero, as a closed mesh.
#pragma once

#include <functional>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Marching tetrahedra (Doi, Koide 1991) on a grid of cubes of at most `edge`, six tets each (Kuhn 1960), over `box`
/// and one cube beyond. `distance` is negative inside; vertices are moved to its zero along the grid's edges, at least
/// a thousandth of an edge away from their ends. Closed, outward. Throws Error: nothing negative in the box, something
/// negative at the rim of the grid (the box is too small), a value not finite, an edge that is not positive or too
/// short for the box.
TriMesh make_level_set(const std::function<double(const dvec3&)>& distance, const Aabb& box, double edge);

}  // namespace taxel
