// Angles between the faces at the edges of a mesh.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel::test {

/// An inner edge with the angle between the normals of its two faces.
struct InnerEdge {
  double length = 0;  ///< length of the edge [m]
  double angle = 0;   ///< dihedral angle [rad]: positive at a ridge, negative in a valley
};

inline std::vector<InnerEdge> inner_edges(const TriMesh& mesh) {
  const EdgeTopology& edges = mesh.topology();
  std::vector<InnerEdge> found;
  for (const auto edge : edges.edges_of(EdgeKind::inner)) {
    const auto normal = [&](int h) { return mesh.face_normals()[static_cast<std::size_t>(h / 3)]; };
    const auto vertex = [&](int v) { return mesh.vertices()[static_cast<std::size_t>(v)]; };
    const dvec3 left = normal(edge[0]), right = normal(edge[1]);
    const dvec3 along = vertex(edges.to(edge[0])) - vertex(edges.from(edge[0]));
    const double length = glm::length(along);
    found.push_back({length, std::atan2(glm::dot(glm::cross(left, right), along / length), glm::dot(left, right))});
  }
  return found;
}

}  // namespace taxel::test
