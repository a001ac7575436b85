#include "ui/scene/geometry/crease_normals.h"

#include "core/base/index.h"

namespace taxel::ui {
namespace {

/// Faces around each vertex: corners [first[v], first[v + 1]) as 3 * face + corner, by face number.
struct VertexFaces {
  std::vector<int> first, corners;
};

VertexFaces faces_of_vertices(const TriMesh& mesh) {
  VertexFaces out;
  out.first.assign(at(mesh.vertex_count()) + 1, 0);
  for (const ivec3& f : mesh.faces()) {
    for (int k = 0; k < 3; ++k) ++out.first[at(f[k]) + 1];
  }
  for (std::size_t v = 1; v < out.first.size(); ++v) out.first[v] += out.first[v - 1];
  std::vector<int> next(out.first.begin(), out.first.end() - 1);
  out.corners.resize(at(3 * mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int k = 0; k < 3; ++k) out.corners[at(next[at(mesh.faces()[at(f)][k])]++)] = 3 * f + k;
  }
  return out;
}

double corner_angle(const TriMesh& mesh, int corner) {
  const int f = corner / 3, k = corner % 3;
  const dvec3 a = mesh.vertex(f, (k + 1) % 3) - mesh.vertex(f, k), b = mesh.vertex(f, (k + 2) % 3) - mesh.vertex(f, k);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

RenderMesh make_render_mesh(const TriMesh& mesh, double crease_deg) {
  const double smooth = std::cos(glm::radians(crease_deg));
  const VertexFaces around = faces_of_vertices(mesh);
  RenderMesh out;
  out.indices.resize(at(3 * mesh.face_count()));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto made = out.vertices.size();  // of this vertex from here on
    for (int i = around.first[at(v)]; i < around.first[at(v) + 1]; ++i) {
      const int corner = around.corners[at(i)];
      const dvec3& own = mesh.face_normals()[at(corner / 3)];
      dvec3 sum(0);
      for (int j = around.first[at(v)]; j < around.first[at(v) + 1]; ++j) {
        const dvec3& other = mesh.face_normals()[at(around.corners[at(j)] / 3)];
        if (glm::dot(own, other) >= smooth) sum += corner_angle(mesh, around.corners[at(j)]) * other;
      }
      const glm::vec3 normal(glm::normalize(glm::dot(sum, sum) > 0 ? sum : own));
      auto k = made;
      while (k < out.vertices.size() && out.vertices[k].normal != normal) ++k;
      if (k == out.vertices.size()) out.vertices.push_back({glm::vec3(mesh.vertices()[at(v)]), normal});
      out.indices[at(corner)] = static_cast<std::uint32_t>(k);
    }
  }
  return out;
}

}  // namespace taxel::ui
