// What a brush paints on a mesh: faces, as sets.
#pragma once

#include <vector>

#include "core/mesh/query/closest_point.h"

namespace taxel {

struct SurfaceBrush {
  double radius = 0.002;      ///< [m]
  double max_angle_deg = 90;  ///< faces turned further away from the one below the brush stay unpainted
};

/// The face at `at`, and all that hang together with it by edges and are reached by the brush: some point of them
/// within its radius of `at.position`, turned away by less than the angle. So neither the opposite wall of a thin shell
/// is painted nor a finger's neighbour. Ascending; at least one face. Costs what lies within the radius.
std::vector<int> faces_under_brush(const MeshIndex& index, const SurfacePoint& at, const SurfaceBrush& brush);

/// Ascending sets of faces: those of either, and those of the first that the second has not.
std::vector<int> with_faces(const std::vector<int>& region, const std::vector<int>& painted);
std::vector<int> without_faces(const std::vector<int>& region, const std::vector<int>& erased);

/// Area of these faces [m^2]. Those that the mesh has not count nothing.
double area_of_faces(const TriMesh& mesh, const std::vector<int>& faces);

}  // namespace taxel
