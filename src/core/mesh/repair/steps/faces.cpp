// Faces that are repeated or folded (several between the same three points), fins, and faces without area.
//
// - Repeated and folded faces are found by sorting the corners of each face: equal ones are neighbours then. Of those
//   that wind alike one stays; two that wind opposite ways enclose nothing and both go.
// - Fins are patches between edges of more than two faces that end open. The smallest goes first, and none next to a
//   smaller one, which may be no fin without it; together at most 2 % of the area.
// - A face without area has its apex on its longest edge. Flipping this edge lets the apex split the face across. The
//   longest edge comes first: every other flat face there gets shorter edges, so the flips come to an end. Rounding may
//   break this proof, so their number is limited, and flat faces that remain are removed.
#include <array>
#include <queue>
#include <set>
#include <tuple>

#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

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

// Fins: patches of surface that stick out of a body and end open.
//
//        ____|____      The patch above the edge | ends open at its top. It encloses nothing.
//       /         \     .

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

// Faces without area: their longest edge is flipped, so that the apex splits the face across.
//
//        x             x
//      /   \         / | \      The face a b c is flat, c lies on the edge a b. Flipped, the edge c x splits a b x.
//     a--c--b       a--c--b

namespace {

using Mesh = Topology::Mesh;

dvec3 point(const Mesh& mesh, OpenMesh::VertexHandle v) {
  const auto& p = mesh.point(v);
  return {p[0], p[1], p[2]};
}

/// The longest half-edge of a face.
OpenMesh::SmartHalfedgeHandle longest_side(const Mesh& mesh, OpenMesh::FaceHandle face) {
  OpenMesh::SmartHalfedgeHandle longest;
  double most = -1;
  for (const OpenMesh::SmartHalfedgeHandle h : mesh.fh_range(face)) {
    const double length = glm::distance(point(mesh, h.from()), point(mesh, h.to()));
    if (length > most) {
      most = length;
      longest = h;
    }
  }
  return longest;
}

bool is_flat_face(const Mesh& mesh, OpenMesh::FaceHandle face) {
  const OpenMesh::SmartHalfedgeHandle h = OpenMesh::make_smart(face, mesh).halfedge();
  return is_flat(point(mesh, h.from()), point(mesh, h.to()), point(mesh, h.next().to()));
}

/// Flat faces by the length of their longest edge, the longest first.
class FlatFaces {
 public:
  FlatFaces(Draft& draft, RepairStep& step)
      : draft_(draft), step_(step), topology_(make_topology(draft, twin_pairs(draft.edges()))) {
    for (int f = 0; f < draft.face_count(); ++f) add(OpenMesh::FaceHandle(f));
  }

  void turn_all() {
    std::vector<char> removed(draft_.faces.size(), 0);
    for (std::size_t budget = 64 * (1 + queue_.size()); !queue_.empty(); --budget) {
      const int face = queue_.top().second;
      queue_.pop();
      if (!is_flat_face(topology_.mesh, OpenMesh::FaceHandle(face))) continue;
      if (budget == 0 || !turn(OpenMesh::FaceHandle(face))) removed[at(face)] = 1;
      if (budget == 0) break;
    }
    while (!queue_.empty()) {
      const int face = queue_.top().second;
      queue_.pop();
      if (is_flat_face(topology_.mesh, OpenMesh::FaceHandle(face))) removed[at(face)] = 1;
    }
    write_back();
    remove_faces(draft_, removed);
  }

 private:
  void add(OpenMesh::FaceHandle face) {
    if (!is_flat_face(topology_.mesh, face)) return;
    const auto h = longest_side(topology_.mesh, face);
    const double length = glm::distance(point(topology_.mesh, h.from()), point(topology_.mesh, h.to()));
    queue_.emplace(static_cast<float>(length), face.idx());
  }

  /// Returns false if there is no face across, or the flipped edge exists already.
  bool turn(OpenMesh::FaceHandle face) {
    Mesh& mesh = topology_.mesh;
    const OpenMesh::SmartHalfedgeHandle side = longest_side(mesh, face);
    add_place(step_, point(mesh, side.next().to()));
    ++step_.faces;
    if (side.opp().is_boundary() || !mesh.is_flip_ok(side.edge())) return false;
    const OpenMesh::FaceHandle across = side.opp().face();
    const int from = draft_.loaded[at(across.idx())];
    if (draft_.loaded[at(face.idx())] < 0) draft_.loaded[at(face.idx())] = from;
    mesh.flip(side.edge());
    add(face);
    add(across);
    return true;
  }

  void write_back() {
    for (int f = 0; f < draft_.face_count(); ++f) {
      int c = 0;
      ivec3 face(0);
      for (const OpenMesh::VertexHandle v : topology_.mesh.fv_range(OpenMesh::FaceHandle(f)))
        face[c++] = topology_.vertex_of[at(v.idx())];
      if (face != draft_.faces[at(f)] && !is_rotated(face, draft_.faces[at(f)])) draft_.faces[at(f)] = face;
    }
  }
  static bool is_rotated(const ivec3& f, const ivec3& g) {
    return f == ivec3(g.y, g.z, g.x) || f == ivec3(g.z, g.x, g.y);
  }

  Draft& draft_;
  RepairStep& step_;
  Topology topology_;
  std::priority_queue<std::pair<float, int>> queue_;  ///< single precision: equal lengths are equal in every unit
};

}  // namespace

RepairStep turn_flat_faces(Draft& draft) {
  RepairStep step = start_step("repair_turned");
  bool any = false;
  for (int f = 0; f < draft.face_count() && !any; ++f)
    any = is_flat(draft.corner(f, 0), draft.corner(f, 1), draft.corner(f, 2));
  if (any) FlatFaces(draft, step).turn_all();
  return step;
}

}  // namespace taxel
