// Sets of faces that a brush paints on a mesh.
#pragma once

#include <vector>

#include "core/mesh/query/closest_point.h"

namespace taxel {

struct SurfaceBrush {
  double radius = 0.002;      ///< [m]
  double max_angle_deg = 90;  ///< faces turned further away from the one below the brush stay unpainted
};

/// Returns the face at `at` and the faces that are connected with it by edges within the brush, ascending: those with a
/// point within the radius of `at.position` and a normal that differs by less than the angle. So neither the opposite
/// wall of a thin shell nor a neighbouring finger is painted. The cost grows with the number of faces in the radius.
std::vector<int> faces_under_brush(const MeshIndex& index, const SurfacePoint& at, const SurfaceBrush& brush);

/// Returns the union of two ascending sets of faces.
std::vector<int> with_faces(const std::vector<int>& region, const std::vector<int>& painted);
/// Returns the faces of the first ascending set that are not in the second one.
std::vector<int> without_faces(const std::vector<int>& region, const std::vector<int>& erased);

/// Returns the area of some faces [m^2]. Numbers that are no face of the mesh add nothing.
double area_of_faces(const TriMesh& mesh, const std::vector<int>& faces);

}  // namespace taxel
