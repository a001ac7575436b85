// The distance between a repaired surface and the loaded one.
#pragma once

#include "core/mesh/query/closest_point.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {

/// Fills report.distance_max, report.distance_rms and changes.distance after a wrap with this edge [m]: from 20000
/// points spread evenly over the repaired mesh to the loaded faces, and from as many on the loaded faces to the
/// repaired mesh. Points of loaded faces that are farther than an edge and do not see the outside are left out. The
/// distance of a vertex is the largest one of the points on, or nearest to, the faces around it.
void measure_distances(const MeshIndex& loaded, double edge, RepairedMesh& repaired);

}  // namespace taxel
