// Each shell is tested against the shells whose boxes contain its own box. A tree over the boxes finds those, so that
// many separate shells cost O(n log n).
#include "core/mesh/topology/enclosed_shells.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "core/mesh/query/bvh.h"
#include "core/mesh/query/solid_angle.h"

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

}  // namespace

std::vector<char> enclosed_shells(const TriMesh& mesh) {
  std::vector<char> enclosed(at(mesh.shell_count()), 0);
  if (mesh.shell_count() < 2) return enclosed;
  const ShellTree shells(mesh);
  for (int s = 0; s < mesh.shell_count(); ++s) enclosed[at(s)] = shells.is_enclosed(s) ? 1 : 0;
  return enclosed;
}

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

}  // namespace taxel
