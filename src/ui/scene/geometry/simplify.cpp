#include "ui/scene/geometry/simplify.h"

#include <algorithm>
#include <array>

#include "core/base/index.h"

namespace taxel::ui {
namespace {

/// Returns the cell of each vertex as the index of a new vertex; cells are numbered by their first vertex. Sets
/// `vertices` to the means of the cells.
std::vector<int> cluster(const TriMesh& mesh, double cell, std::vector<dvec3>& vertices) {
  using Key = std::array<std::int64_t, 4>;  // cell, vertex
  std::vector<Key> keys;
  keys.reserve(at(mesh.vertex_count()));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const dvec3 c = glm::floor((mesh.vertices()[at(v)] - mesh.bounds().lo) / cell);
    keys.push_back({static_cast<std::int64_t>(c.x), static_cast<std::int64_t>(c.y), static_cast<std::int64_t>(c.z), v});
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> cluster_of(at(mesh.vertex_count()));
  for (std::size_t i = 0; i < keys.size();) {
    dvec3 sum(0);
    std::size_t end = i;
    for (; end < keys.size() && std::equal(keys[i].begin(), keys[i].begin() + 3, keys[end].begin()); ++end) {
      sum += mesh.vertices()[static_cast<std::size_t>(keys[end][3])];
      cluster_of[static_cast<std::size_t>(keys[end][3])] = static_cast<int>(vertices.size());
    }
    vertices.push_back(sum / static_cast<double>(end - i));
    i = end;
  }
  return cluster_of;
}

/// Returns the face with its lowest corner first.
ivec3 turned(const ivec3& f) {
  if (f.x < f.y && f.x < f.z) return f;
  return f.y < f.z ? ivec3(f.y, f.z, f.x) : ivec3(f.z, f.x, f.y);
}

}  // namespace

TriMeshPtr simplify(const TriMeshPtr& mesh, int faces) {
  // A surface of area A over cells of width h has about A / h^2 vertices, and twice as many faces.
  const double cell = std::sqrt(2 * mesh->area() / faces);
  std::vector<dvec3> vertices;
  const std::vector<int> cluster_of = cluster(*mesh, cell, vertices);
  std::vector<ivec3> kept;
  for (int i = 0; i < mesh->face_count(); ++i) {
    const ivec3& f = mesh->faces()[at(i)];
    ivec3 g(cluster_of[at(f.x)], cluster_of[at(f.y)], cluster_of[at(f.z)]);
    if (g.x == g.y || g.y == g.z || g.z == g.x) continue;
    const dvec3 normal = glm::cross(vertices[at(g.y)] - vertices[at(g.x)], vertices[at(g.z)] - vertices[at(g.x)]);
    if (glm::dot(normal, mesh->face_normals()[at(i)]) < 0) std::swap(g.y, g.z);  // the face was flipped by the move
    if (glm::length(normal) > 0) kept.push_back(turned(g));
  }
  const auto before = [](const ivec3& a, const ivec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::sort(kept.begin(), kept.end(), before);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  if (kept.empty()) return mesh;
  return std::make_shared<const TriMesh>(std::move(vertices), std::move(kept));
}

}  // namespace taxel::ui
