// Winding: neighbours wind alike, closed shells outward, and cavities inward.
//
// Faces that wind alike across their edges form regions. Regions are joined to patches across their borders, the
// longest border first, and along each one side is turned. A border that contradicts those before is a seam. So one
// wrong edge makes one short seam and does not turn half of the mesh. Patches with long seams and open edges are bands
// without two sides (Moebius strips), and are left to a later step. In each patch the side with more area keeps its
// winding.
//
// A closed shell has a positive volume, unless it is a cavity: the winding number of all other shells at points just
// outside of its largest faces says whether it is inside of a solid.
#include <map>
#include <set>

#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/query/winding_number.h"
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

/// Faces in patches, and in each patch which faces wind against the others.
class Regions {
 public:
  explicit Regions(const Draft& draft) : region_(draft.faces.size()), patch_(draft.faces.size()) {
    std::vector<std::pair<int, int>> unlike;
    const EdgeTopology edges = draft.edges();
    edges.for_each_edge([&](std::span<const int> edge) {
      const EdgeKind kind = edges.kind(edge);
      if (kind == EdgeKind::inner) region_.unite(edge[0] / 3, edge[1] / 3);
      if (kind == EdgeKind::misoriented) unlike.emplace_back(edge[0] / 3, edge[1] / 3);
    });
    std::map<std::pair<int, int>, int> borders;  // number of edges between two regions
    for (const auto& [f, g] : unlike) {
      const int a = region_.find(f), b = region_.find(g);
      --borders[{std::min(a, b), std::max(a, b)}];
    }
    std::vector<std::pair<int, std::pair<int, int>>> by_length;
    for (const auto& [regions, count] : borders) by_length.emplace_back(count, regions);
    std::sort(by_length.begin(), by_length.end());
    parity_.assign(draft.faces.size(), 0);
    members_.resize(draft.faces.size());
    for (int f = 0; f < draft.face_count(); ++f)
      if (region_.find(f) == f) members_[at(f)].push_back(f);
    for (const auto& [count, regions] : by_length) join(regions.first, regions.second, -count);
  }

  [[nodiscard]] int patch(int face) { return patch_.find(region_.find(face)); }
  [[nodiscard]] bool is_turned(int face) { return parity_[at(region_.find(face))] != 0; }
  /// Edges of the seams of each patch, at its number.
  [[nodiscard]] const std::map<int, int>& seams() {
    for (const auto& [region, count] : seam_edges_) seams_[patch_.find(region)] += count;
    seam_edges_.clear();
    return seams_;
  }

 private:
  void join(int a, int b, int edges) {
    const int patch_a = patch_.find(a), patch_b = patch_.find(b);
    if (patch_a == patch_b) {
      if (parity_[at(a)] == parity_[at(b)]) seam_edges_.emplace_back(a, edges);
      return;
    }
    const bool turn_b = parity_[at(a)] == parity_[at(b)];
    patch_.unite(patch_a, patch_b);
    const int kept = patch_.find(patch_a), merged = kept == patch_a ? patch_b : patch_a;
    for (const int region : members_[at(merged)]) {
      if (turn_b) parity_[at(region)] = 1 - parity_[at(region)];
      members_[at(kept)].push_back(region);
    }
    members_[at(merged)].clear();
  }

  DisjointSets region_, patch_;
  std::vector<int> parity_;                ///< parity of each region, by its first face
  std::vector<std::vector<int>> members_;  ///< regions of each patch
  std::vector<std::pair<int, int>> seam_edges_;
  std::map<int, int> seams_;
};

/// Patches that cannot be oriented and are bands rather than bodies: many of their edges are open or on a seam.
std::set<int> find_bands(const Draft& draft, Regions& regions) {
  constexpr double kOpenPart = 0.15;         // of the edges, of a band
  std::map<int, std::pair<int, int>> edges;  // open and all edges of the patches with seams
  for (const auto& [patch, count] : regions.seams()) edges[patch] = {count, 0};
  if (edges.empty()) return {};
  draft.edges().for_each_edge([&](std::span<const int> edge) {
    const auto found = edges.find(regions.patch(edge[0] / 3));
    if (found == edges.end()) return;
    found->second.first += edge.size() == 1 ? 1 : 0;
    ++found->second.second;
  });
  std::set<int> bands;
  for (const auto& [patch, counts] : edges)
    if (counts.first > kOpenPart * counts.second) bands.insert(patch);
  return bands;
}

void turn(Draft& draft, int face, RepairStep& step) {
  ivec3& ids = draft.faces[at(face)];
  std::swap(ids.y, ids.z);
  add_place(step, draft.center(face));
  ++step.faces;
}

}  // namespace

RepairStep wind_alike(Draft& draft, std::vector<char>& unorientable) {
  RepairStep step = start_step("repair_oriented");
  Regions regions(draft);
  const std::set<int> bands = find_bands(draft, regions);
  // The side of a patch that holds more area keeps its winding.
  std::vector<double> balance(draft.faces.size(), 0);
  for (int f = 0; f < draft.face_count(); ++f)
    balance[at(regions.patch(f))] += regions.is_turned(f) ? -draft.area(f) : draft.area(f);
  unorientable.assign(draft.faces.size(), 0);
  for (int f = 0; f < draft.face_count(); ++f) {
    if (bands.contains(regions.patch(f)))
      unorientable[at(f)] = 1;
    else if (regions.is_turned(f) == (balance[at(regions.patch(f))] >= 0))
      turn(draft, f, step);
  }
  return step;
}

namespace {

/// Returns the winding number of all other shells around a shell, at the middle of its largest faces. Just outside of a
/// face the winding number of the shell itself is 0, or -1 if it is a cavity or inside out.
double winding_of_others(const Draft& draft, const WindingNumber& winding, const std::vector<int>& shell, double volume,
                         double step_out) {
  constexpr std::size_t kProbes = 3;
  std::vector<int> largest = shell;
  const std::size_t probes = std::min(kProbes, largest.size());
  std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(probes), largest.end(),
                    [&](int a, int b) {
                      const double area_a = draft.area(a), area_b = draft.area(b);
                      return area_a != area_b ? area_a > area_b : a < b;
                    });
  double sum = 0;
  for (std::size_t i = 0; i < probes; ++i) {
    const dvec3 n = glm::normalize(draft.area_normal(largest[i]));
    sum += winding(draft.center(largest[i]) + step_out * n) + (volume < 0 ? 1 : 0);
  }
  return sum / static_cast<double>(probes);
}

void turn_shell(Draft& draft, const std::vector<int>& shell, RepairStep& step) {
  for (const int f : shell) {
    std::swap(draft.faces[at(f)].y, draft.faces[at(f)].z);
    add_place(step, draft.center(f));
    ++step.faces;
  }
}

}  // namespace

RepairStep orient_shells(Draft& draft) {
  RepairStep step = start_step("repair_oriented");
  const FaceShells shells = find_shells(draft);
  if (shells.faces.size() == 1) {
    if (volume_of(draft, shells.faces[0]) < 0) turn_shell(draft, shells.faces[0], step);
    return step;
  }
  Aabb box;
  for (const dvec3& p : draft.points) box.include(p);
  const double step_out = 1e-7 * box.diagonal();
  const WindingNumber winding(draft.points, draft.faces);
  for (const std::vector<int>& shell : shells.faces) {
    const double volume = volume_of(draft, shell);
    const double others = winding_of_others(draft, winding, shell, volume, step_out);
    // A cavity is inside a solid. A shell in a body that is inside out is inside out as well.
    if ((volume < 0 && others < 0.5) || (volume > 0 && others < -0.5)) turn_shell(draft, shell, step);
  }
  return step;
}

}  // namespace taxel
