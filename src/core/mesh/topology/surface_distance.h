// The distance between two surfaces.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Distances from points of each surface to the closest point of the other surface [m].
struct SurfaceDistance {
  double largest = 0;  ///< a lower bound of the Hausdorff distance; exact for vertices
  double rms = 0;      ///< root mean square over points spread over both surfaces
};

/// Measures both ways: from all vertices, and from `points` points spread evenly by area. Deterministic.
SurfaceDistance measure_surface_distance(const TriMeshPtr& a, const TriMeshPtr& b, int points = 20000);

}  // namespace taxel
