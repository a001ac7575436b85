// The shortest path itself, traced back through the windows that a propagation left.
#pragma once

#include <vector>

#include "core/mesh/geodesic/geodesic_distance.h"

namespace taxel {

/// From the source of the last propagation to a point of a face: straight pieces, each within one face, which bend at
/// edges and where the path goes over a vertex. Its length is from.to(face, target) to within rounding. `source`: the
/// point that was propagated from. Empty where the target was not reached.
std::vector<dvec3> geodesic_path(const UnfoldedMesh& mesh, const GeodesicDistance& from, const dvec3& source, int face,
                                 const dvec3& target);

}  // namespace taxel
