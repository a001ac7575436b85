// The surface where a function of space is zero, as a closed mesh.
#pragma once

#include <functional>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The place of a vertex on an edge of the grid of a level set.
enum class EdgeZero {
  exact,  ///< the zero of the function, a thousandth of an edge from the ends
  linear  ///< the zero of a line through both values, a fiftieth from the ends
};

/// Marching tetrahedra (Doi, Koide 1991) on a grid of cubes of at most `edge`, six tets each (Kuhn 1960), over `box`
/// and one cube beyond. `distance` is negative inside. The mesh is closed and oriented outward, and no faces cross,
/// because each is within a tet. It has no faces if no value in the box is negative. Throws Error if a value at the rim
/// of the grid is negative (the box is too small), if one is not finite, or if the edge is not positive or too short
/// for the box.
TriMesh make_level_set(const std::function<double(const dvec3&)>& distance, const Aabb& box, double edge,
                       EdgeZero zero = EdgeZero::exact);

}  // namespace taxel
