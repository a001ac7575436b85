// Comparison of two meshes: the motion between two copies of one mesh, and the distance between two surfaces.
#pragma once

#include <optional>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the pose X for which to = X(from), for meshes with the same faces in the same order. Returns nothing if
/// there is none that brings each corner of `from` within `tolerance` [m] of its place.
std::optional<Pose> find_rigid_motion(const TriMesh& from, const TriMesh& to, double tolerance);

/// Distances from points of each surface to the closest point of the other surface [m].
struct SurfaceDistance {
  double largest = 0;  ///< a lower bound of the Hausdorff distance; exact for vertices
  double rms = 0;      ///< root mean square over points spread over both surfaces
};

/// Measures both ways: from all vertices, and from `points` points spread evenly by area. Deterministic.
SurfaceDistance measure_surface_distance(const TriMeshPtr& a, const TriMeshPtr& b, int points = 20000);

}  // namespace taxel
