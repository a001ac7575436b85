// Half-edges of any triangles as a manifold, and surfaces that only touch parted from each other.
//
// Twins, where an edge has two faces that run opposite ways, join corners of faces; each set of joined corners is one
// fan of faces and becomes one vertex. So OpenMesh gets a manifold whatever the triangles are, and every face is kept.
//
// At an edge of four or more faces, the angles of the faces around the edge say which two belong together: a face that
// is seen from its back begins a sector of solid, and the next one seen from its front ends it, as brackets do. Fans
// that become separate by this get points of their own. If two groups of an edge share both of its ends, parting the
// vertices does not part them; their faces are first split at a middle vertex for each group.
//
// Pitfall: faces at one angle are ordered so that sectors end before others begin, and bodies that touch there stay
// two.
#include "core/mesh/repair/topology.h"

#include <array>
#include <set>
#include <tuple>

#include "core/base/math.h"
#include "core/mesh/repair/steps.h"

namespace taxel {

std::vector<HalfEdgePair> twin_pairs(const EdgeTopology& edges) {
  std::vector<HalfEdgePair> pairs;
  pairs.reserve(at(edges.edge_count()));
  edges.for_each_edge([&](std::span<const int> edge) {
    if (edges.kind(edge) == EdgeKind::inner) pairs.push_back({edge[0], edge[1]});
  });
  return pairs;
}

DisjointSets join_corners(const Draft& draft, std::span<const HalfEdgePair> pairs) {
  DisjointSets corners(3 * draft.faces.size());
  for (const HalfEdgePair& pair : pairs) {
    corners.unite(pair.a, next_edge(pair.b));
    corners.unite(next_edge(pair.a), pair.b);
  }
  return corners;
}

namespace {

/// Adds a face with three vertices of its own.
void add_alone(Topology& topology, const Draft& draft, int face) {
  std::array<OpenMesh::VertexHandle, 3> handles;
  for (int c = 0; c < 3; ++c) {
    const dvec3& p = draft.corner(face, c);
    handles[at(c)] = topology.mesh.add_vertex({p.x, p.y, p.z});
    topology.vertex_of.push_back(draft.faces[at(face)][c]);
  }
  topology.mesh.add_face(handles[0], handles[1], handles[2]);
}

}  // namespace

/// Around one vertex of one fan the faces lie in a row or in a ring, each joined to the next across an edge that both
/// pass in opposite directions. So no side is taken twice, and OpenMesh accepts every face. Several pairs at one edge
/// that share both of its ends are the exception: part_touching() splits such edges beforehand, and a face that
/// OpenMesh still refuses gets vertices of its own.
Topology make_topology(const Draft& draft, std::span<const HalfEdgePair> pairs) {
  DisjointSets corners = join_corners(draft, pairs);
  Topology topology;
  topology.mesh.reserve(draft.points.size(), 3 * draft.faces.size() / 2, draft.faces.size());
  std::vector<OpenMesh::VertexHandle> vertex_of_fan(3 * draft.faces.size());
  for (int f = 0; f < draft.face_count(); ++f) {
    std::array<OpenMesh::VertexHandle, 3> handles;
    for (int c = 0; c < 3; ++c) {
      OpenMesh::VertexHandle& handle = vertex_of_fan[at(corners.find(3 * f + c))];
      if (!handle.is_valid()) {
        const dvec3& p = draft.corner(f, c);
        handle = topology.mesh.add_vertex({p.x, p.y, p.z});
        topology.vertex_of.push_back(draft.faces[at(f)][c]);
      }
      handles[at(c)] = handle;
    }
    if (!topology.mesh.add_face(handles[0], handles[1], handles[2]).is_valid()) add_alone(topology, draft, f);
  }
  return topology;
}

int find_patches(const Draft& draft, std::span<const HalfEdgePair> pairs, std::vector<int>& patch_of_face) {
  DisjointSets sets(draft.faces.size());
  for (const HalfEdgePair& pair : pairs) sets.unite(pair.a / 3, pair.b / 3);
  patch_of_face.resize(draft.faces.size());
  int count = 0;
  for (int f = 0; f < draft.face_count(); ++f) {
    const int first = sets.find(f);
    patch_of_face[at(f)] = first == f ? count++ : patch_of_face[at(first)];
  }
  return count;
}

// Surfaces that only touch along an edge or at a point are parted there, so that each is a manifold of its own.
//
//        \  solid  /        Around an edge of four faces, counter-clockwise: a face seen from its back begins a
//     out \       / out     solid sector, the next one seen from its front ends it. Both belong together, as an
//          \     /          opening bracket and the next closing one do.
//           >edge<

namespace {

/// A half-edge with the angle of its face around the edge, counter-clockwise seen from the edge's high end [rad].
struct AroundEdge {
  double angle;
  int h;
};

std::vector<AroundEdge> sort_around(const Draft& draft, const EdgeTopology& edges, std::span<const int> edge) {
  const dvec3 &low = draft.points[at(edges.low(edge[0]))], &high = draft.points[at(edges.high(edge[0]))];
  const dvec3 axis = glm::normalize(high - low);
  const auto offset = [&](int h) {
    const dvec3 to_apex = draft.points[at(edges.from(previous_edge(h)))] - low;
    return to_apex - axis * glm::dot(to_apex, axis);
  };
  const dvec3 x = offset(edge[0]), y = glm::cross(axis, x);
  constexpr double kSameAngle = 1e-9;
  std::vector<AroundEdge> around;
  for (const int h : edge) {
    const dvec3 v = offset(h);
    double angle = std::atan2(glm::dot(v, y), glm::dot(v, x));
    if (angle < -kSameAngle) angle += 2 * kPi;
    around.push_back({angle, h});
  }
  std::sort(around.begin(), around.end(),
            [](const AroundEdge& a, const AroundEdge& b) { return std::tie(a.angle, a.h) < std::tie(b.angle, b.h); });
  // At one angle the sectors that end come before those that begin: bodies that touch there stay two.
  for (std::size_t begin = 0, end = 0; begin < around.size(); begin = end) {
    while (end < around.size() && around[end].angle - around[begin].angle <= kSameAngle) ++end;
    std::stable_sort(
        around.begin() + static_cast<std::ptrdiff_t>(begin), around.begin() + static_cast<std::ptrdiff_t>(end),
        [&](const AroundEdge& a, const AroundEdge& b) { return edges.is_forward(a.h) && !edges.is_forward(b.h); });
  }
  return around;
}

/// Twice around the edge: sectors that begin before the first angle end in the second round.
void pair_around(const Draft& draft, const EdgeTopology& edges, std::span<const int> edge,
                 std::vector<HalfEdgePair>& pairs) {
  const std::vector<AroundEdge> around = sort_around(draft, edges, edge);
  std::vector<int> begun;
  std::vector<char> ended(around.size(), 0);
  for (std::size_t i = 0; i < 2 * around.size(); ++i) {
    const int h = around[i % around.size()].h;
    if (!edges.is_forward(h)) {
      if (i < around.size()) begun.push_back(h);
    } else if (ended[i % around.size()] == 0 && !begun.empty()) {
      ended[i % around.size()] = 1;
      pairs.push_back({begun.back(), h});
      begun.pop_back();
    }
  }
}

/// Half-edges of one edge that stay together: two of a pair, or one without a partner.
using Group = std::vector<int>;

/// Finds edges whose groups share the vertices at both ends: parting the vertices does not part these.
class SharedEdges {
 public:
  SharedEdges(const Draft& draft, const EdgeTopology& edges)
      : edges_(edges), corners_(3 * draft.faces.size()), partner_(3 * draft.faces.size(), -1) {
    const std::vector<HalfEdgePair> pairs = pair_half_edges(draft, edges);
    corners_ = join_corners(draft, pairs);
    for (const HalfEdgePair& pair : pairs) {
      partner_[at(pair.a)] = pair.b;
      partner_[at(pair.b)] = pair.a;
    }
  }

  [[nodiscard]] std::vector<Group> groups(std::span<const int> edge) const {
    std::vector<Group> found;
    for (const int h : edge) {
      const int partner = partner_[at(h)];
      if (partner < 0)
        found.push_back({h});
      else if (h < partner)
        found.push_back({h, partner});
    }
    return found;
  }
  [[nodiscard]] bool is_shared(std::span<const Group> groups) {
    std::set<std::pair<int, int>> ends;
    for (const Group& group : groups) {
      const int h = group.front(), from = corners_.find(h), to = corners_.find(next_edge(h));
      if (!ends.insert(edges_.is_forward(h) ? std::pair(from, to) : std::pair(to, from)).second) return true;
    }
    return false;
  }

 private:
  const EdgeTopology& edges_;
  DisjointSets corners_;
  std::vector<int> partner_;  ///< partner of each half-edge, or -1
};

/// Splits the faces of each group at a middle vertex of the group's own.
void split_groups(Draft& draft, const EdgeTopology& edges, std::span<const Group> groups) {
  for (const Group& group : groups) {
    const int low = edges.low(group.front()), high = edges.high(group.front());
    const int middle = draft.add_point(0.5 * (draft.points[at(low)] + draft.points[at(high)]));
    for (const int h : group) {
      const int a = edges.from(h), b = edges.to(h), x = edges.from(previous_edge(h));
      draft.faces[at(h / 3)] = {a, middle, x};
      draft.add({middle, b, x}, draft.loaded[at(h / 3)]);
    }
  }
}

/// One round: no face is split twice in it. `edges` are those of the draft. Returns false if nothing was to be split.
bool split_shared_edges(Draft& draft, const EdgeTopology& edges) {
  const std::vector<std::span<const int>> crowded = edges.edges_of(EdgeKind::nonmanifold);
  if (crowded.empty()) return false;
  SharedEdges shared(draft, edges);
  std::vector<std::vector<Group>> found;
  std::set<int> used;
  for (const std::span<const int> edge : crowded) {
    std::vector<Group> groups = shared.groups(edge);
    if (!shared.is_shared(groups)) continue;
    if (std::any_of(edge.begin(), edge.end(), [&](int h) { return used.contains(h / 3); })) continue;
    for (const int h : edge) used.insert(h / 3);
    found.push_back(std::move(groups));
  }
  for (const std::vector<Group>& groups : found) split_groups(draft, edges, groups);
  return !found.empty();
}

/// Gives each closed fan but the first one at a point a point of its own. Fans that end open keep the point: a hole
/// between them is still to be filled.
void part_vertices(Draft& draft, std::span<const HalfEdgePair> pairs, RepairStep& step) {
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

/// Returns true if some point has more than one fan of faces.
bool has_several_fans(const Draft& draft, std::span<const HalfEdgePair> pairs) {
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

std::vector<HalfEdgePair> pair_half_edges(const Draft& draft, const EdgeTopology& edges) {
  std::vector<HalfEdgePair> pairs;
  pairs.reserve(at(edges.edge_count()));
  edges.for_each_edge([&](std::span<const int> edge) {
    const EdgeKind kind = edges.kind(edge);
    if (kind == EdgeKind::nonmanifold) pair_around(draft, edges, edge, pairs);
    if (kind == EdgeKind::inner) pairs.push_back({edge[0], edge[1]});
  });
  return pairs;
}

RepairStep part_touching(Draft& draft, RepairChanges& changes) {
  constexpr int kMaxRounds = 16;
  RepairStep step = start_step("repair_parted");
  EdgeTopology edges = draft.edges();
  for (const std::span<const int> edge : edges.edges_of(EdgeKind::nonmanifold)) {
    const dvec3 &a = draft.points[at(edges.low(edge[0]))], &b = draft.points[at(edges.high(edge[0]))];
    changes.parted_edges.emplace_back(a, b);
    add_place(step, 0.5 * (a + b));
  }
  for (int round = 0; round < kMaxRounds && split_shared_edges(draft, edges); ++round) edges = draft.edges();
  const std::vector<HalfEdgePair> pairs = pair_half_edges(draft, edges);
  if (has_several_fans(draft, pairs)) part_vertices(draft, pairs, step);
  return step;
}

}  // namespace taxel
