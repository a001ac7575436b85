#include "ui/scene/geometry/render_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/math.h"

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

RenderMesh make_render_mesh(const TriMesh& mesh, double crease_deg, std::span<const glm::vec2> texture_coords) {
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
      const auto is_same = [&](std::size_t vertex) {
        return out.vertices[vertex].normal == normal &&
               (texture_coords.empty() || out.texture_coords[vertex] == texture_coords[at(corner)]);
      };
      auto k = made;
      while (k < out.vertices.size() && !is_same(k)) ++k;
      if (k == out.vertices.size()) {
        out.vertices.push_back({glm::vec3(mesh.vertices()[at(v)]), normal});
        if (!texture_coords.empty()) out.texture_coords.push_back(texture_coords[at(corner)]);
      }
      out.indices[at(corner)] = static_cast<std::uint32_t>(k);
    }
  }
  return out;
}

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

void order_back_to_front(std::span<const glm::vec3> centroids, std::span<const std::uint32_t> indices,
                         const glm::vec3& direction, std::vector<std::uint32_t>& out) {
  constexpr std::size_t kDepths = 4096;
  std::vector<float> depth(centroids.size());
  float lo = std::numeric_limits<float>::infinity(), hi = -lo;
  for (std::size_t f = 0; f < centroids.size(); ++f) {
    depth[f] = glm::dot(centroids[f], direction);
    lo = std::min(lo, depth[f]);
    hi = std::max(hi, depth[f]);
  }
  const float scale = hi > lo ? static_cast<float>(kDepths - 1) / (hi - lo) : 0.0f;
  const auto bucket = [&](std::size_t f) { return static_cast<std::size_t>((hi - depth[f]) * scale); };
  std::array<std::size_t, kDepths + 1> first{};
  for (std::size_t f = 0; f < depth.size(); ++f) ++first[bucket(f) + 1];
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  out.resize(indices.size());
  for (std::size_t f = 0; f < depth.size(); ++f) {
    const auto slot = first[bucket(f)]++;
    std::copy_n(indices.begin() + static_cast<std::ptrdiff_t>(3 * f), 3,
                out.begin() + static_cast<std::ptrdiff_t>(3 * slot));
  }
}

}  // namespace taxel::ui
