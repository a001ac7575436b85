#include "ui/scene/geometry/visible_edges.h"

#include <cmath>

#include "core/base/index.h"

namespace taxel::ui {
std::vector<MeshEdge> mesh_edges(const TriMesh& mesh, double crease_deg) {
  const double smooth = std::cos(glm::radians(crease_deg));
  const EdgeTopology& topology = mesh.topology();
  std::vector<MeshEdge> edges;
  edges.reserve(at(topology.edge_count()));
  topology.for_each_edge([&](std::span<const int> half_edges) {
    const int h = half_edges[0];
    MeshEdge edge{topology.low(h), topology.high(h), h / 3, half_edges.size() > 1 ? half_edges[1] / 3 : -1, false};
    edge.crease = half_edges.size() != 2 ||
                  glm::dot(mesh.face_normals()[at(edge.left)], mesh.face_normals()[at(edge.right)]) < smooth;
    edges.push_back(edge);
  });
  return edges;
}

VisibleEdges visible_edges(const TriMesh& mesh, const std::vector<MeshEdge>& edges, const dvec3& eye) {
  std::vector<char> towards(at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    towards[at(f)] = glm::dot(mesh.face_normals()[at(f)], eye - mesh.vertex(f, 0)) > 0 ? 1 : 0;
  }
  VisibleEdges out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const MeshEdge& e = edges[i];
    const bool left = towards[at(e.left)] != 0, right = e.right >= 0 && towards[at(e.right)] != 0;
    if (e.right >= 0 && left != right) {
      out.outline.push_back(static_cast<int>(i));
    } else if (e.crease && (left || right)) {
      out.creases.push_back(static_cast<int>(i));
    }
  }
  return out;
}

}  // namespace taxel::ui
