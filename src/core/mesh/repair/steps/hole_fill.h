// Triangulation of the rim of a hole.
#pragma once

#include <functional>
#include <optional>

#include "core/mesh/repair/draft.h"

namespace taxel {

/// The rim of a hole: corners in the direction in which the faces that fill it run along it.
struct HoleRim {
  std::vector<dvec3> corners;  ///< in any unit
  std::vector<dvec3> normals;  ///< unit normal of the face outside of the edge from each corner to the next one
  /// Whether corners i and j may be joined by a new edge: not if an edge joins them already.
  std::function<bool(int, int)> may_join;
};

/// Triangles between the corners: of least (largest dihedral angle, area) by dynamic programming (Barequet, Sharir
/// 1995, "Filling gaps in the boundary of a polyhedron"; with the angles of Liepa 2003, "Filling holes in meshes").
/// O(n^3). Empty if no triangulation is allowed.
std::optional<std::vector<ivec3>> fill_by_least_angle(const HoleRim& rim);

/// Triangles between the corners: ears cut off the rim's projection onto its mean plane, for rims of many corners.
/// O(n^2). Empty if no ear is allowed at some point.
std::optional<std::vector<ivec3>> fill_by_ears(const HoleRim& rim);

}  // namespace taxel
