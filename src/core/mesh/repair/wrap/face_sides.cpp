#include "core/mesh/repair/wrap/face_sides.h"

#include "core/base/index.h"
#include "core/mesh/query/disjoint_sets.h"

namespace taxel {
namespace {

/// A nonzero entry for each face that crosses another one or has a corner at an edge where the surface ends.
std::vector<char> find_unknown(const TriMesh& mesh, const std::vector<std::pair<int, int>>& crossing) {
  std::vector<char> unknown(mesh.faces().size(), 0), ends(mesh.vertices().size(), 0);
  for (const auto& [f, g] : crossing) unknown[at(f)] = unknown[at(g)] = 1;
  const EdgeTopology& edges = mesh.topology();
  for (int h = 0; h < edges.half_edge_count(); ++h)
    if (edges.twin(h) < 0) ends[at(edges.from(h))] = ends[at(edges.to(h))] = 1;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int c = 0; c < 3; ++c)
      if (ends[at(mesh.faces()[at(f)][c])] != 0) unknown[at(f)] = 1;
  return unknown;
}

/// The sides of a face around which, without itself, faces wind by `winding`: half more is inside, half less outside.
FaceSides sides_of(double winding) {
  constexpr double kMargin = 0.3;
  const double inner = winding + 0.5, outer = winding - 0.5;
  if (outer > 0.5 + kMargin) return FaceSides::both_inside;
  if (inner < 0.5 - kMargin) return FaceSides::both_outside;
  return inner > 0.5 + kMargin && outer < 0.5 - kMargin ? FaceSides::skin : FaceSides::unknown;
}

}  // namespace

std::vector<FaceSides> find_face_sides(const TriMesh& mesh, const std::vector<std::pair<int, int>>& crossing,
                                       const WindingNumber& winding) {
  constexpr int kMaxFaces = 8;  // evaluated faces of a patch with rims
  const std::vector<char> unknown = find_unknown(mesh, crossing);
  DisjointSets patches(mesh.faces().size());
  const EdgeTopology& edges = mesh.topology();
  for (int h = 0; h < edges.half_edge_count(); ++h) {
    const int other = edges.face_across(h);
    if (other >= 0 && unknown[at(h / 3)] == 0 && unknown[at(other)] == 0) patches.unite(h / 3, other);
  }
  std::vector<std::vector<int>> members(mesh.faces().size());
  for (int f = 0; f < mesh.face_count(); ++f)
    if (unknown[at(f)] == 0) members[at(patches.find(f))].push_back(f);
  std::vector<FaceSides> sides(mesh.faces().size(), FaceSides::unknown);
  for (const std::vector<int>& patch : members) {
    if (patch.empty()) continue;
    const int count = mesh.closed() ? 1 : std::min(kMaxFaces, static_cast<int>(patch.size()));
    double mean = 0;
    for (int i = 0; i < count; ++i) {
      const int f = patch[patch.size() * (2 * at(i) + 1) / (2 * at(count))];
      const dvec3 center = (mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)) / 3.0;
      mean += winding.without(center, f) / count;
    }
    for (const int f : patch) sides[at(f)] = sides_of(mean);
  }
  return sides;
}

}  // namespace taxel
