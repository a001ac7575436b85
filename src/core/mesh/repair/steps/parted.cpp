// Surfaces that only touch along an edge or at a point are parted there, so that each is a manifold of its own.
//
//        \  solid  /        Around an edge of four faces, counter-clockwise: a face seen from its back begins a
//     out \       / out     solid sector, the next one seen from its front ends it. Both belong together, as an
//          \     /          opening bracket and the next closing one do.
//           >edge<
#include "core/mesh/repair/steps/parted.h"

#include <set>
#include <tuple>

#include "core/base/math.h"
#include "core/mesh/repair/steps.h"

namespace taxel {
namespace {

/// A side of an edge by the angle of its face around the edge, counter-clockwise seen from the edge's high end.
struct AroundEdge {
  double angle;
  EdgeSide side;
};

std::vector<AroundEdge> sort_around(const Draft& draft, std::span<const EdgeSide> edge) {
  const dvec3 &low = draft.points[at(edge[0].low)], &high = draft.points[at(edge[0].high)];
  const dvec3 axis = glm::normalize(high - low);
  const auto offset = [&](const EdgeSide& side) {
    const dvec3 to_apex = draft.corner(side.face, (side.corner + 2) % 3) - low;
    return to_apex - axis * glm::dot(to_apex, axis);
  };
  const dvec3 x = offset(edge[0]), y = glm::cross(axis, x);
  constexpr double kSameAngle = 1e-9;
  std::vector<AroundEdge> around;
  for (const EdgeSide& side : edge) {
    const dvec3 v = offset(side);
    double angle = std::atan2(glm::dot(v, y), glm::dot(v, x));
    if (angle < -kSameAngle) angle += 2 * kPi;
    around.push_back({angle, side});
  }
  std::sort(around.begin(), around.end(), [](const AroundEdge& a, const AroundEdge& b) {
    return std::tie(a.angle, a.side.face) < std::tie(b.angle, b.side.face);
  });
  // At one angle the sectors that end come before those that begin: bodies that touch there stay two.
  for (std::size_t begin = 0, end = 0; begin < around.size(); begin = end) {
    while (end < around.size() && around[end].angle - around[begin].angle <= kSameAngle) ++end;
    std::stable_sort(around.begin() + static_cast<std::ptrdiff_t>(begin),
                     around.begin() + static_cast<std::ptrdiff_t>(end),
                     [](const AroundEdge& a, const AroundEdge& b) { return a.side.forward && !b.side.forward; });
  }
  return around;
}

/// Twice around the edge: sectors that begin before the first angle end in the second round.
void pair_around(const Draft& draft, std::span<const EdgeSide> edge, std::vector<SidePair>& pairs) {
  const std::vector<AroundEdge> around = sort_around(draft, edge);
  std::vector<EdgeSide> begun;
  std::vector<char> ended(around.size(), 0);
  for (std::size_t i = 0; i < 2 * around.size(); ++i) {
    const EdgeSide& side = around[i % around.size()].side;
    if (!side.forward) {
      if (i < around.size()) begun.push_back(side);
    } else if (ended[i % around.size()] == 0 && !begun.empty()) {
      ended[i % around.size()] = 1;
      pairs.push_back({begun.back(), side});
      begun.pop_back();
    }
  }
}

/// Sides of one edge that stay together: two of a pair, or one that found none.
using Group = std::vector<EdgeSide>;

/// Finds edges whose groups share the vertices at both ends: parting the vertices does not part these.
class SharedEdges {
 public:
  SharedEdges(const Draft& draft, std::span<const SidePair> pairs)
      : corners_(join_corners(draft, pairs)), partner_(3 * draft.faces.size(), {-1, -1, -1, -1, false}) {
    for (const SidePair& pair : pairs) {
      partner_[at(3 * pair.a.face + pair.a.corner)] = pair.b;
      partner_[at(3 * pair.b.face + pair.b.corner)] = pair.a;
    }
  }

  [[nodiscard]] std::vector<Group> groups(std::span<const EdgeSide> edge) const {
    std::vector<Group> found;
    for (const EdgeSide& side : edge) {
      const EdgeSide& partner = partner_[at(3 * side.face + side.corner)];
      if (partner.face < 0)
        found.push_back({side});
      else if (side.face < partner.face)
        found.push_back({side, partner});
    }
    return found;
  }
  [[nodiscard]] bool is_shared(std::span<const Group> groups) {
    std::set<std::pair<int, int>> ends;
    for (const Group& group : groups) {
      const EdgeSide& s = group.front();
      const int from = corners_.find(3 * s.face + s.corner), to = corners_.find(3 * s.face + (s.corner + 1) % 3);
      if (!ends.insert(s.forward ? std::pair(from, to) : std::pair(to, from)).second) return true;
    }
    return false;
  }

 private:
  DisjointSets corners_;
  std::vector<EdgeSide> partner_;  ///< partner of the side at 3 face + corner; its face is -1 if it has none
};

/// Splits the faces of each group at a middle vertex of the group's own.
void split_groups(Draft& draft, std::span<const Group> groups) {
  for (const Group& group : groups) {
    const EdgeSide& first = group.front();
    const int middle = draft.add_point(0.5 * (draft.points[at(first.low)] + draft.points[at(first.high)]));
    for (const EdgeSide& side : group) {
      const ivec3 ids = draft.faces[at(side.face)];
      const int a = ids[side.corner], b = ids[(side.corner + 1) % 3], x = ids[(side.corner + 2) % 3];
      draft.faces[at(side.face)] = {a, middle, x};
      draft.add({middle, b, x}, draft.loaded[at(side.face)]);
    }
  }
}

/// One round: no face is split twice in it. Returns false if nothing was to be split.
bool split_shared_edges(Draft& draft) {
  const std::vector<EdgeSide> sides = draft.sides();
  bool any = false;
  for_each_edge(std::span(sides), [&](std::span<const EdgeSide> edge) { any = any || edge.size() > 2; });
  if (!any) return false;
  SharedEdges shared(draft, pair_sides(draft, sides));
  std::vector<std::vector<Group>> found;
  std::set<int> used;
  for_each_edge(std::span(sides), [&](std::span<const EdgeSide> edge) {
    if (edge.size() <= 2) return;
    std::vector<Group> groups = shared.groups(edge);
    if (!shared.is_shared(groups)) return;
    if (std::any_of(edge.begin(), edge.end(), [&](const EdgeSide& s) { return used.contains(s.face); })) return;
    for (const EdgeSide& side : edge) used.insert(side.face);
    found.push_back(std::move(groups));
  });
  for (const std::vector<Group>& groups : found) split_groups(draft, groups);
  return !found.empty();
}

/// Gives each closed fan but the first one at a point a point of its own. Fans that end open keep the point: a hole
/// between them is still to be filled.
void part_vertices(Draft& draft, std::span<const SidePair> pairs, RepairStep& step) {
  const Topology topology = make_topology(draft, pairs);
  std::vector<int> point_of(topology.vertex_of.size());
  std::vector<char> used(draft.points.size(), 0);
  for (const bool open : {true, false}) {
    for (const OpenMesh::SmartVertexHandle v : topology.mesh.vertices()) {
      if (v.is_boundary() != open) continue;
      const int point = topology.vertex_of[at(v.idx())];
      point_of[at(v.idx())] = point;
      if (!open && used[at(point)] != 0) {
        point_of[at(v.idx())] = draft.add_point(dvec3(draft.points[at(point)]));
        add_place(step, draft.points[at(point)]);
      }
      used[at(point)] = 1;
    }
  }
  for (int f = 0; f < draft.face_count(); ++f) {
    for (const OpenMesh::VertexHandle v : topology.mesh.fv_range(OpenMesh::FaceHandle(f))) {
      const int point = topology.vertex_of[at(v.idx())];
      draft.faces[at(f)][corner_at(draft.faces[at(f)], point)] = point_of[at(v.idx())];
    }
  }
}

/// Whether some point has more than one fan of faces.
bool has_several_fans(const Draft& draft, std::span<const SidePair> pairs) {
  DisjointSets corners = join_corners(draft, pairs);
  std::vector<int> fan_of(draft.points.size(), -1);
  for (int f = 0; f < draft.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      int& fan = fan_of[at(draft.faces[at(f)][c])];
      const int own = corners.find(3 * f + c);
      if (fan >= 0 && fan != own) return true;
      fan = own;
    }
  }
  return false;
}

}  // namespace

std::vector<SidePair> pair_sides(const Draft& draft, std::span<const EdgeSide> sides) {
  std::vector<SidePair> pairs;
  pairs.reserve(sides.size() / 2);
  for_each_edge(sides, [&](std::span<const EdgeSide> edge) {
    if (edge.size() > 2)
      pair_around(draft, edge, pairs);
    else if (edge.size() == 2 && edge[0].forward != edge[1].forward)
      pairs.push_back({edge[0], edge[1]});
  });
  return pairs;
}

RepairStep part_touching(Draft& draft, RepairChanges& changes) {
  constexpr int kMaxRounds = 16;
  RepairStep step = start_step("repair_parted");
  const std::vector<EdgeSide> loaded_sides = draft.sides();
  for_each_edge(std::span(loaded_sides), [&](std::span<const EdgeSide> edge) {
    if (edge.size() <= 2) return;
    const dvec3 &a = draft.points[at(edge[0].low)], &b = draft.points[at(edge[0].high)];
    changes.parted_edges.emplace_back(a, b);
    add_place(step, 0.5 * (a + b));
  });
  for (int round = 0; round < kMaxRounds && split_shared_edges(draft); ++round) {
  }
  const std::vector<EdgeSide> sides = draft.sides();
  const std::vector<SidePair> pairs = pair_sides(draft, sides);
  if (has_several_fans(draft, pairs)) part_vertices(draft, pairs, step);
  return step;
}

}  // namespace taxel
