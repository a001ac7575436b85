#include <utility>

#include "core/base/index.h"
#include "core/mesh/topology/enclosed_shells.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// A face across an edge of two faces.
struct Link {
  int face = -1;
  bool is_alike = true;  ///< true if both faces wind alike
};

/// The links of each face, in the order of edges.
std::vector<std::vector<Link>> find_links(const TriMesh& mesh) {
  std::vector<std::vector<Link>> result(at(mesh.face_count()));
  const EdgeTopology& edges = mesh.topology();
  edges.for_each_edge([&](std::span<const int> edge) {
    if (edge.size() != 2) return;
    const int f = edge[0] / 3, g = edge[1] / 3;
    const bool is_alike = edges.kind(edge) == EdgeKind::inner;
    result[at(f)].push_back({g, is_alike});
    result[at(g)].push_back({f, is_alike});
  });
  return result;
}

/// Signed volume of each shell [m^3] (divergence theorem; the apex is a vertex of the shell).
std::vector<double> shell_volumes(const TriMesh& mesh) {
  std::vector<double> volumes(at(mesh.shell_count()), 0);
  std::vector<int> first(volumes.size(), -1);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::size_t shell = at(mesh.shell_of_face()[at(f)]);
    if (first[shell] < 0) first[shell] = f;
    const dvec3& apex = mesh.vertex(first[shell], 0);
    const dvec3 a = mesh.vertex(f, 0) - apex, b = mesh.vertex(f, 1) - apex, c = mesh.vertex(f, 2) - apex;
    volumes[shell] += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volumes;
}

}  // namespace

TriMesh oriented(const TriMesh& mesh) {
  const std::vector<std::vector<Link>> neighbours = find_links(mesh);
  std::vector<int> turned(at(mesh.face_count()), -1);  // -1 until reached
  std::vector<ivec3> faces = mesh.faces();
  std::vector<int> queue;
  for (int seed = 0; seed < mesh.face_count(); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    queue.assign(1, seed);
    turned[at(seed)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Link& link : neighbours[at(queue[i])]) {
        if (turned[at(link.face)] >= 0) continue;
        turned[at(link.face)] = link.is_alike ? turned[at(queue[i])] : 1 - turned[at(queue[i])];
        queue.push_back(link.face);
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (turned[f] == 1) std::swap(faces[f].y, faces[f].z);
  }
  TriMesh alike(mesh.vertices(), std::move(faces));
  if (!alike.closed()) return alike;
  // A closed shell encloses a positive volume, a cavity a negative one.
  std::vector<char> flip(at(alike.shell_count()), 0);
  const std::vector<double> volumes = shell_volumes(alike);
  const std::vector<char> enclosed = enclosed_shells(alike);
  for (std::size_t s = 0; s < flip.size(); ++s) flip[s] = (volumes[s] < 0) != (enclosed[s] != 0) ? 1 : 0;
  faces = alike.faces();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (flip[at(alike.shell_of_face()[f])] != 0) std::swap(faces[f].y, faces[f].z);
  }
  return {mesh.vertices(), std::move(faces)};
}

}  // namespace taxel
