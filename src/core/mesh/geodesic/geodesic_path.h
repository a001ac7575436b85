// The shortest path on a mesh, traced back through the windows of a propagation.
#pragma once

#include <vector>

#include "core/mesh/geodesic/geodesic_distance.h"

namespace taxel {

/// Returns the path from `source`, the source of the last propagation, to a point of a face: the ends of straight
/// pieces, each within one face. The length is from.to(face, target) to within rounding. Empty if the target was not
/// reached.
std::vector<dvec3> geodesic_path(const UnfoldedMesh& mesh, const GeodesicDistance& from, const dvec3& source, int face,
                                 const dvec3& target);

}  // namespace taxel
