// Finds the edges of a mesh that a drawing shows: creases, and the outline as seen from a point.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel::ui {

struct MeshEdge {
  int a = 0, b = 0;           ///< vertices, a < b
  int left = -1, right = -1;  ///< faces; right is -1 at a border
  bool crease = false;        ///< a border, or the faces meet at more than the crease angle
};

/// Returns every edge once, ordered by (a, b). An edge of more than two faces has the first two of them and is a
/// crease.
std::vector<MeshEdge> mesh_edges(const TriMesh& mesh, double crease_deg = 30.0);

/// The visible edges as ascending indices: outline edges separate faces that look towards `eye` from faces that look
/// away, and visible creases touch a face that looks towards `eye`. `eye` is in the frame of the mesh.
struct VisibleEdges {
  std::vector<int> outline, creases;
};
VisibleEdges visible_edges(const TriMesh& mesh, const std::vector<MeshEdge>& edges, const dvec3& eye);

}  // namespace taxel::ui
