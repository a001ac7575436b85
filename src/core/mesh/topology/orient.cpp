#include <utility>

#include "core/base/index.h"
#include "core/mesh/topology/edge_sides.h"
#include "core/mesh/topology/enclosed_shells.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

/// A face across an edge with exactly two faces, and whether both wind alike.
struct Link {
  int face = -1;
  bool alike = true;
};

std::vector<std::vector<Link>> links(const TriMesh& mesh) {
  std::vector<std::vector<Link>> result(at(mesh.face_count()));
  for_each_edge(edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2) return;
    const bool alike = sides[0].forward != sides[1].forward;
    result[at(sides[0].face)].push_back({sides[1].face, alike});
    result[at(sides[1].face)].push_back({sides[0].face, alike});
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
  const std::vector<std::vector<Link>> neighbours = links(mesh);
  std::vector<int> turned(at(mesh.face_count()), -1);  // -1: not seen yet
  std::vector<ivec3> faces = mesh.faces();
  std::vector<int> queue;
  for (int seed = 0; seed < mesh.face_count(); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    queue.assign(1, seed);
    turned[at(seed)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Link& link : neighbours[at(queue[i])]) {
        if (turned[at(link.face)] >= 0) continue;
        turned[at(link.face)] = link.alike ? turned[at(queue[i])] : 1 - turned[at(queue[i])];
        queue.push_back(link.face);
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (turned[f] == 1) std::swap(faces[f].y, faces[f].z);
  }
  TriMesh alike(mesh.vertices(), faces);
  if (!alike.closed()) return alike;
  // A closed shell encloses a positive volume, a cavity a negative one.
  std::vector<char> flip(at(alike.shell_count()), 0);
  const std::vector<double> volumes = shell_volumes(alike);
  const std::vector<char> enclosed = enclosed_shells(alike);
  for (std::size_t s = 0; s < flip.size(); ++s) flip[s] = (volumes[s] < 0) != (enclosed[s] != 0) ? 1 : 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (flip[at(alike.shell_of_face()[f])] != 0) std::swap(faces[f].y, faces[f].z);
  }
  return {mesh.vertices(), std::move(faces)};
}

}  // namespace taxel
