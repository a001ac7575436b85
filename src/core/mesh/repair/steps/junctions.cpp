// T-junctions: an open edge on which a rim point of other faces lies is split there.
#include <map>

#include "core/mesh/query/bvh.h"
#include "core/mesh/repair/steps.h"

namespace taxel {
namespace {

/// Open edges as half-edges, and the points at their ends.
struct Rims {
  std::vector<int> edges;
  std::vector<int> points;
};

Rims find_rims(const Draft& draft) {
  Rims rims;
  const EdgeTopology edges = draft.edges();
  for (const std::span<const int> edge : edges.edges_of(EdgeKind::boundary)) {
    rims.edges.push_back(edge[0]);
    rims.points.push_back(edges.from(edge[0]));
    rims.points.push_back(edges.to(edge[0]));
  }
  std::sort(rims.points.begin(), rims.points.end());
  rims.points.erase(std::unique(rims.points.begin(), rims.points.end()), rims.points.end());
  return rims;
}

/// The rim points on an edge, from its first end to its second one.
class PointsOnEdges {
 public:
  PointsOnEdges(const Draft& draft, const std::vector<int>& points, double within)
      : draft_(draft), points_(points), within_(within) {
    std::vector<Aabb> boxes;
    for (const int v : points) {
      boxes.emplace_back();
      boxes.back().include(draft.points[at(v)] - within);
      boxes.back().include(draft.points[at(v)] + within);
    }
    bvh_.build(boxes);
  }

  [[nodiscard]] std::vector<int> find(int face, int corner) const {
    const ivec3& ids = draft_.faces[at(face)];
    const int a = ids[corner], b = ids[(corner + 1) % 3], x = ids[(corner + 2) % 3];
    const dvec3 &p = draft_.points[at(a)], edge = draft_.points[at(b)] - p;
    const double length = glm::length(edge);
    Aabb box;
    box.include(p);
    box.include(draft_.points[at(b)]);
    std::vector<std::pair<double, int>> found;
    bvh_.visit([&](const Aabb& node) { return node.overlaps(box); },
               [&](int i) {
                 const int v = points_[at(i)];
                 if (v == a || v == b || v == x) return;
                 const dvec3 offset = draft_.points[at(v)] - p;
                 const double t = glm::dot(offset, edge) / length;
                 if (t <= within_ || t >= length - within_) return;
                 if (glm::length(offset - edge * (t / length)) <= within_) found.emplace_back(t, v);
               });
    std::sort(found.begin(), found.end());
    std::vector<int> points;
    for (const auto& [t, v] : found) points.push_back(v);
    return points;
  }

 private:
  const Draft& draft_;
  const std::vector<int>& points_;
  double within_;
  Bvh bvh_;
};

/// Replaces a face by a fan of faces from the corner across its edge. The first one keeps the face's number.
void split(Draft& draft, int face, int corner, const std::vector<int>& points) {
  const ivec3 ids = draft.faces[at(face)];
  const int apex = ids[(corner + 2) % 3], from = draft.loaded[at(face)];
  int last = ids[corner];
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const int next = i < points.size() ? points[i] : ids[(corner + 1) % 3];
    if (i == 0)
      draft.faces[at(face)] = {last, next, apex};
    else
      draft.add({last, next, apex}, from);
    last = next;
  }
}

}  // namespace

RepairStep split_junctions(Draft& draft, const RepairLimits& limits) {
  constexpr double kWithin = 1e-5;  // tolerance as a fraction of the diagonal
  constexpr int kMaxRounds = 16;    // a face with several such edges has one of them split in each round
  RepairStep step = start_step("repair_split");
  for (int round = 0; round < kMaxRounds; ++round) {
    const Rims rims = find_rims(draft);
    const PointsOnEdges on_edges(draft, rims.points, kWithin * limits.diagonal);
    std::map<int, std::pair<int, std::vector<int>>> splits;  // face -> corner and points
    for (const int h : rims.edges) {
      std::vector<int> points = on_edges.find(h / 3, h % 3);
      if (!points.empty()) splits.try_emplace(h / 3, h % 3, std::move(points));
    }
    if (splits.empty()) break;
    for (const auto& [face, where] : splits) {
      for (const int v : where.second) add_place(step, draft.points[at(v)]);
      step.faces += static_cast<int>(where.second.size());
      split(draft, face, where.first, where.second);
    }
  }
  return step;
}

}  // namespace taxel
