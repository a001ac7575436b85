// Fins: patches of surface that stick out of a body and end open.
//
//        ____|____      The patch above the edge | ends open at its top. It encloses nothing.
//       /         \     .
#include <set>

#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

/// A patch of faces between edges of more than two faces.
struct Patch {
  std::vector<int> faces;
  std::vector<int> crowded_edges;  ///< edges of more than two faces at its border, by number
  double area = 0;
  bool open = false;
};

/// Patches are joined across every edge of two faces, however these wind.
std::vector<Patch> find_all_patches(const Draft& draft, const EdgeTopology& edges) {
  std::vector<HalfEdgePair> pairs;
  edges.for_each_edge([&](std::span<const int> edge) {
    if (edge.size() == 2) pairs.push_back({edge[0], edge[1]});
  });
  std::vector<int> patch_of_face;
  std::vector<Patch> patches(at(find_patches(draft, pairs, patch_of_face)));
  for (int f = 0; f < draft.face_count(); ++f) {
    Patch& patch = patches[at(patch_of_face[at(f)])];
    patch.faces.push_back(f);
    patch.area += draft.area(f);
  }
  int crowded = 0;
  edges.for_each_edge([&](std::span<const int> edge) {
    for (const int h : edge) {
      Patch& patch = patches[at(patch_of_face[at(h / 3)])];
      if (edge.size() > 2) patch.crowded_edges.push_back(crowded);
      patch.open = patch.open || edge.size() == 1;
    }
    if (edge.size() > 2) ++crowded;
  });
  return patches;
}

/// Fins that can go at once: the smallest first, and none next to a smaller one, which may be no fin without it.
std::vector<const Patch*> find_fins(const std::vector<Patch>& patches, double area_left) {
  std::vector<const Patch*> fins;
  for (const Patch& patch : patches)
    if (patch.open && !patch.crowded_edges.empty()) fins.push_back(&patch);
  std::stable_sort(fins.begin(), fins.end(), [](const Patch* a, const Patch* b) { return a->area < b->area; });
  std::set<int> used_edges;
  std::erase_if(fins, [&](const Patch* fin) {
    const auto& edges = fin->crowded_edges;
    const bool next_to_other = std::any_of(edges.begin(), edges.end(), [&](int e) { return used_edges.contains(e); });
    used_edges.insert(edges.begin(), edges.end());
    area_left -= next_to_other ? 0 : fin->area;
    return next_to_other || area_left < 0;
  });
  return fins;
}

}  // namespace

RepairStep remove_fins(Draft& draft, const RepairLimits& limits) {
  constexpr double kMaxFraction = 0.02;  // largest fraction of the loaded area
  RepairStep step = start_step("repair_fin");
  for (;;) {
    const std::vector<Patch> patches = find_all_patches(draft, draft.edges());
    const std::vector<const Patch*> fins = find_fins(patches, kMaxFraction * limits.loaded_area - step.area);
    if (fins.empty()) return step;
    std::vector<char> removed(draft.faces.size(), 0);
    for (const Patch* fin : fins) {
      for (const int f : fin->faces) removed[at(f)] = 1;
      add_place(step, draft.center(fin->faces.front()));
      step.faces += static_cast<int>(fin->faces.size());
      step.area += fin->area;
    }
    remove_faces(draft, removed);
  }
}

}  // namespace taxel
