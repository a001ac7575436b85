#include "ui/scene/geometry/mesh_edges.h"

#include <algorithm>

#include "core/base/index.h"

namespace taxel::ui {
std::vector<MeshEdge> mesh_edges(const TriMesh& mesh, double crease_deg) {
  struct Half {
    int a, b, face;
  };
  std::vector<Half> halves;
  halves.reserve(at(3 * mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& v = mesh.faces()[at(f)];
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(v[k], v[(k + 1) % 3]);
      halves.push_back({a, b, f});
    }
  }
  std::sort(halves.begin(), halves.end(),
            [](const Half& x, const Half& y) { return std::tie(x.a, x.b, x.face) < std::tie(y.a, y.b, y.face); });
  const double smooth = std::cos(glm::radians(crease_deg));
  std::vector<MeshEdge> edges;
  for (std::size_t i = 0; i < halves.size();) {
    std::size_t end = i + 1;
    while (end < halves.size() && halves[end].a == halves[i].a && halves[end].b == halves[i].b) ++end;
    MeshEdge edge{halves[i].a, halves[i].b, halves[i].face, end - i > 1 ? halves[i + 1].face : -1, false};
    edge.crease =
        end - i != 2 || glm::dot(mesh.face_normals()[at(edge.left)], mesh.face_normals()[at(edge.right)]) < smooth;
    edges.push_back(edge);
    i = end;
  }
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
