// Repeated and folded faces: several faces between the same three points.
#include <array>
#include <tuple>

#include "core/mesh/repair/steps.h"

namespace taxel {
namespace {

/// A face by its corners in ascending order, with its winding relative to that order.
struct SortedFace {
  std::array<int, 3> corners;
  int face;
  bool even;
};

std::vector<SortedFace> sorted_faces(const Draft& draft) {
  std::vector<SortedFace> sorted;
  sorted.reserve(draft.faces.size());
  for (int f = 0; f < draft.face_count(); ++f) {
    std::array<int, 3> corners{draft.faces[at(f)].x, draft.faces[at(f)].y, draft.faces[at(f)].z};
    bool even = true;
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)}) {
      if (corners[at(i)] <= corners[at(j)]) continue;
      std::swap(corners[at(i)], corners[at(j)]);
      even = !even;
    }
    sorted.push_back({corners, f, even});
  }
  std::sort(sorted.begin(), sorted.end(), [](const SortedFace& a, const SortedFace& b) {
    return std::tie(a.corners, a.face) < std::tie(b.corners, b.face);
  });
  return sorted;
}

/// Calls body(faces between the same three points) for every group of several faces.
template <class Body>
void for_each_stack(const std::vector<SortedFace>& sorted, const Body& body) {
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].corners == sorted[begin].corners) ++end;
    if (end - begin > 1) body(std::span(sorted).subspan(begin, end - begin));
  }
}

/// Marks a face for removal.
void mark(const Draft& draft, int face, std::vector<char>& removed, RepairStep& step) {
  removed[at(face)] = 1;
  add_place(step, draft.center(face));
  ++step.faces;
  step.area += draft.area(face);
}

/// Removes pairs of opposite faces, or only the later face of each.
RepairStep remove_pairs(Draft& draft, bool keeps_first) {
  RepairStep step = start_step("repair_folded");
  std::vector<char> removed(draft.faces.size(), 0);
  for_each_stack(sorted_faces(draft), [&](std::span<const SortedFace> stack) {
    std::vector<int> forward, backward;
    for (const SortedFace& entry : stack) (entry.even ? forward : backward).push_back(entry.face);
    for (std::size_t i = 0; i < std::min(forward.size(), backward.size()); ++i) {
      const auto [first, last] = std::minmax(forward[i], backward[i]);
      if (!keeps_first) mark(draft, first, removed, step);
      mark(draft, last, removed, step);
    }
  });
  if (step.count > 0) remove_faces(draft, removed);
  return step;
}

}  // namespace

RepairStep remove_repeated(Draft& draft) {
  RepairStep step = start_step("repair_repeated");
  std::vector<char> removed(draft.faces.size(), 0);
  for_each_stack(sorted_faces(draft), [&](std::span<const SortedFace> stack) {
    bool seen[2] = {false, false};
    for (const SortedFace& entry : stack) {
      if (seen[entry.even ? 1 : 0]) mark(draft, entry.face, removed, step);
      seen[entry.even ? 1 : 0] = true;
    }
  });
  if (step.count > 0) remove_faces(draft, removed);
  return step;
}

RepairStep remove_folded(Draft& draft) {
  return remove_pairs(draft, false);
}

RepairStep remove_back_faces(Draft& draft) {
  return remove_pairs(draft, true);
}

}  // namespace taxel
