#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/mesh/query/bvh.h"
#include "core/mesh/query/solid_angle.h"
#include "core/mesh/topology/mesh_check.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

namespace {

bool contains(const Aabb& outer, const Aabb& inner) {
  return glm::all(glm::lessThanEqual(outer.lo, inner.lo)) && glm::all(glm::lessThanEqual(inner.hi, outer.hi));
}

/// The shells of a mesh with their faces and boxes.
class ShellTree {
 public:
  explicit ShellTree(const TriMesh& mesh) : mesh_(mesh), faces_(at(mesh.shell_count())), boxes_(faces_.size()) {
    for (int f = 0; f < mesh.face_count(); ++f) {
      const std::size_t shell = at(mesh.shell_of_face()[at(f)]);
      faces_[shell].push_back(f);
      for (int c = 0; c < 3; ++c) boxes_[shell].include(mesh.vertex(f, c));
    }
    bvh_.build(boxes_);
  }

  [[nodiscard]] bool is_enclosed(int shell) const {
    const Aabb& box = boxes_[at(shell)];
    const std::vector<dvec3> probes = probe_points(shell);
    bool enclosed = false;
    bvh_.visit([&](const Aabb& outer) { return !enclosed && contains(outer, box); },
               [&](int other) {
                 if (!enclosed && other != shell && contains(boxes_[at(other)], box))
                   enclosed = winds_around(other, probes);
               });
    return enclosed;
  }

 private:
  [[nodiscard]] bool winds_around(int shell, const std::vector<dvec3>& probes) const {
    double mean = 0;
    for (const dvec3& p : probes) mean += std::abs(winding_number(shell, p)) / static_cast<double>(probes.size());
    return mean > 0.5;
  }

  /// Returns the winding number of `shell` around p: 1 or -1 inside a closed shell, 0 outside.
  [[nodiscard]] double winding_number(int shell, const dvec3& p) const {
    double sum = 0;
    for (const int f : faces_[at(shell)])
      sum += solid_angle(mesh_.vertex(f, 0) - p, mesh_.vertex(f, 1) - p, mesh_.vertex(f, 2) - p);
    return sum / (4.0 * kPi);
  }

  /// Returns the centres of some faces of a shell, spread over its list of faces.
  [[nodiscard]] std::vector<dvec3> probe_points(int shell) const {
    constexpr std::size_t kProbes = 8;
    const std::vector<int>& faces = faces_[at(shell)];
    const std::size_t count = std::min(kProbes, faces.size());
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < count; ++i) {
      const int f = faces[i * faces.size() / count];
      points.push_back((mesh_.vertex(f, 0) + mesh_.vertex(f, 1) + mesh_.vertex(f, 2)) / 3.0);
    }
    return points;
  }

  const TriMesh& mesh_;
  std::vector<std::vector<int>> faces_;  // per shell
  std::vector<Aabb> boxes_;              // per shell
  Bvh bvh_;                              // over boxes_
};

/// Returns 1 for each shell inside another shell (shell_is_enclosed()), and 0 for the others.
std::vector<char> enclosed_shells(const TriMesh& mesh) {
  std::vector<char> enclosed(at(mesh.shell_count()), 0);
  if (mesh.shell_count() < 2) return enclosed;
  const ShellTree shells(mesh);
  for (int s = 0; s < mesh.shell_count(); ++s) enclosed[at(s)] = shells.is_enclosed(s) ? 1 : 0;
  return enclosed;
}

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

bool shell_is_enclosed(const TriMesh& mesh, int shell) {
  return mesh.shell_count() > 1 && ShellTree(mesh).is_enclosed(shell);
}

std::vector<int> outer_shells(const TriMesh& mesh) {
  const std::vector<char> enclosed = enclosed_shells(mesh);
  std::vector<int> outer;
  for (int s = 0; s < mesh.shell_count(); ++s)
    if (enclosed[at(s)] == 0) outer.push_back(s);
  return outer;
}

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
