#include "core/mesh/repair/wrap/face_sides.h"

#include "core/base/index.h"
#include "core/mesh/query/disjoint_sets.h"

namespace taxel {
namespace {

/// A nonzero entry for each face that crosses another one or has a corner at an edge where the surface ends.
std::vector<char> find_unknown(const TriMesh& mesh, std::vector<char> crosses) {
  std::vector<char> unknown = std::move(crosses), ends(mesh.vertices().size(), 0);
  const EdgeTopology& edges = mesh.topology();
  for (int h = 0; h < edges.half_edge_count(); ++h)
    if (edges.twin(h) < 0) ends[at(edges.from(h))] = ends[at(edges.to(h))] = 1;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int c = 0; c < 3; ++c)
      if (ends[at(mesh.faces()[at(f)][c])] != 0) unknown[at(f)] = 1;
  return unknown;
}

}  // namespace

FaceSideFinder::FaceSideFinder(const TriMesh& mesh, std::vector<char> crosses, const WindingNumber& winding)
    : mesh_(mesh), winding_(winding), patch_of_face_(mesh.faces().size(), -1) {
  const std::vector<char> unknown = find_unknown(mesh, std::move(crosses));
  DisjointSets sets(mesh.faces().size());
  const EdgeTopology& edges = mesh.topology();
  for (int h = 0; h < edges.half_edge_count(); ++h) {
    const int other = edges.face_across(h);
    if (other >= 0 && unknown[at(h / 3)] == 0 && unknown[at(other)] == 0) sets.unite(h / 3, other);
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (unknown[at(f)] != 0) continue;
    const int first = sets.find(f);
    if (first == f) patches_.emplace_back();
    patch_of_face_[at(f)] = first == f ? static_cast<int>(patches_.size()) - 1 : patch_of_face_[at(first)];
    patches_[at(patch_of_face_[at(f)])].push_back(f);
  }
  sides_.resize(patches_.size());
}

FaceSides FaceSideFinder::sides_of(int face) {
  const int patch = patch_of_face_[at(face)];
  if (patch < 0) return FaceSides::unknown;
  if (!sides_[at(patch)]) sides_[at(patch)] = sides_of_patch(patches_[at(patch)]);
  return *sides_[at(patch)];
}

/// Around a face, without itself, faces wind by the mean of both sides: half more is inside, half less outside.
FaceSides FaceSideFinder::sides_of_patch(const std::vector<int>& patch) const {
  constexpr int kMaxFaces = 8;  // evaluated faces of a patch with rims
  constexpr double kMargin = 0.3;
  const int count = mesh_.closed() ? 1 : std::min(kMaxFaces, static_cast<int>(patch.size()));
  double mean = 0;
  for (int i = 0; i < count; ++i) {
    const int f = patch[patch.size() * (2 * at(i) + 1) / (2 * at(count))];
    const dvec3 center = (mesh_.vertex(f, 0) + mesh_.vertex(f, 1) + mesh_.vertex(f, 2)) / 3.0;
    mean += winding_.without(center, f) / count;
  }
  const double inner = mean + 0.5, outer = mean - 0.5;
  if (outer > 0.5 + kMargin) return FaceSides::both_inside;
  if (inner < 0.5 - kMargin) return FaceSides::both_outside;
  return inner > 0.5 + kMargin && outer < 0.5 - kMargin ? FaceSides::skin : FaceSides::unknown;
}

}  // namespace taxel
