// Winding: neighbours wind alike, and shells outward.
#include "core/mesh/disjoint_sets.h"
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

/// A face across an edge of two faces, and whether both wind alike.
struct Link {
  int face = -1;
  bool alike = true;
};

std::vector<std::vector<Link>> find_links(const Draft& draft) {
  std::vector<std::vector<Link>> links(draft.faces.size());
  const std::vector<EdgeSide> sides = draft.sides();
  for_each_edge(sides, [&](std::span<const EdgeSide> edge) {
    if (edge.size() != 2) return;
    const bool alike = edge[0].forward != edge[1].forward;
    links[at(edge[0].face)].push_back({edge[1].face, alike});
    links[at(edge[1].face)].push_back({edge[0].face, alike});
  });
  return links;
}

/// Floods one patch from a face. `turned` is -1 for unseen faces, and afterwards 1 for those that wind against the
/// first one. Returns false if the patch cannot be oriented.
bool flood(const std::vector<std::vector<Link>>& links, int seed, std::vector<int>& turned, std::vector<int>& patch) {
  bool orientable = true;
  patch.assign(1, seed);
  turned[at(seed)] = 0;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    for (const Link& link : links[at(patch[i])]) {
      const int wanted = link.alike ? turned[at(patch[i])] : 1 - turned[at(patch[i])];
      if (turned[at(link.face)] < 0) {
        turned[at(link.face)] = wanted;
        patch.push_back(link.face);
      } else if (turned[at(link.face)] != wanted) {
        orientable = false;
      }
    }
  }
  return orientable;
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
  const std::vector<std::vector<Link>> links = find_links(draft);
  std::vector<int> turned(draft.faces.size(), -1), patch;
  unorientable.assign(draft.faces.size(), 0);
  for (int seed = 0; seed < draft.face_count(); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    const bool orientable = flood(links, seed, turned, patch);
    // The side that holds more area keeps its winding.
    double area[2] = {0, 0};
    for (const int f : patch) area[turned[at(f)]] += draft.area(f);
    const int minority = area[1] > area[0] ? 0 : 1;
    std::sort(patch.begin(), patch.end());
    for (const int f : patch) {
      if (!orientable)
        unorientable[at(f)] = 1;
      else if (turned[at(f)] == minority)
        turn(draft, f, step);
    }
  }
  return step;
}

}  // namespace taxel
