// Rims that rounding has torn apart: points of open edges that are almost at the same place become one, and open edges
// are split at junctions.
//
// Joining. The distance at which points belong together is not known, so eight radii are tried, from 1e-7 to 3e-4 of
// the diagonal. A radius is better if fewer edges are open then; but each thousand closed edges may cost only one edge
// of three faces, or walls of thin bodies would be joined. A point joins an earlier rim point within the radius, never
// a chain of them, so none moves farther. Cost: one pass over the rim points by a grid, and one count of edges, per
// radius.
//
// Junctions. An open edge on which rim points of other faces lie is split there into a fan of faces. A face with
// several such edges has one of them split in each round.
#include <array>
#include <bit>
#include <cstdint>
#include <map>

#include "core/mesh/query/bvh.h"
#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/repair/steps.h"

namespace taxel {
namespace {

std::vector<int> rim_points(const Draft& draft) {
  std::vector<int> points;
  const EdgeTopology edges = draft.edges();
  for (const std::span<const int> edge : edges.edges_of(EdgeKind::boundary)) {
    points.push_back(edges.from(edge[0]));
    points.push_back(edges.to(edge[0]));
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Points in a grid of cells a little more than twice as wide as the reach, so that eight cells hold all points within
/// reach of a place. Cells share the lists of a table by their hash.
class PointGrid {
 public:
  PointGrid(double reach, std::size_t count)
      : reach_(reach), width_(2 * kSlack * reach), first_(std::bit_ceil(2 * count + 1), -1) {}

  void add(int number, const dvec3& p) {
    int& first = first_[slot(glm::floor(p / width_))];
    points_.push_back({p, number, first});
    first = static_cast<int>(points_.size()) - 1;
  }

  /// The nearest point within the reach, the lowest number among equals; -1 if there is none.
  [[nodiscard]] int nearest(const dvec3& p) const {
    const dvec3 low = glm::floor((p - kSlack * reach_) / width_);
    int best = -1;
    double least = reach_;
    for (int i = 0; i < 8; ++i) {
      const dvec3 cell = low + dvec3(i & 1, i >> 1 & 1, i >> 2);
      for (int entry = first_[slot(cell)]; entry >= 0; entry = points_[at(entry)].next) {
        const Entry& q = points_[at(entry)];
        const double distance = glm::distance(p, q.position);
        if (distance > least || (distance == least && best >= 0 && best < q.number)) continue;
        best = q.number;
        least = distance;
      }
    }
    return best;
  }

 private:
  static constexpr double kSlack = 1.001;  ///< more than any rounding of a cell's number
  struct Entry {
    dvec3 position;
    int number, next;  ///< `next` is the number of another entry of the list, or -1
  };
  [[nodiscard]] std::size_t slot(const dvec3& cell) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]))) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    return hash & (first_.size() - 1);
  }
  double reach_, width_;
  std::vector<int> first_;  ///< first entry of each list, or -1
  std::vector<Entry> points_;
};

/// Each point by itself.
std::vector<int> unjoined(std::size_t count) {
  std::vector<int> joined(count);
  for (std::size_t v = 0; v < count; ++v) joined[v] = static_cast<int>(v);
  return joined;
}

/// For each point the one that it is joined to. A point joins an earlier rim point within r, never a chain of them, so
/// that none moves further than r.
std::vector<int> joined_points(const Draft& draft, const std::vector<int>& rim, double r) {
  std::vector<int> joined = unjoined(draft.points.size());
  PointGrid kept(r, rim.size());
  for (const int v : rim) {
    const int near_point = kept.nearest(draft.points[at(v)]);
    if (near_point >= 0)
      joined[at(v)] = near_point;
    else
      kept.add(v, draft.points[at(v)]);
  }
  return joined;
}

std::vector<ivec3> renumbered(const std::vector<ivec3>& faces, const std::vector<int>& joined) {
  std::vector<ivec3> result;
  result.reserve(faces.size());
  for (const ivec3& f : faces) result.emplace_back(joined[at(f.x)], joined[at(f.y)], joined[at(f.z)]);
  return result;
}

bool has_equal_corners(const ivec3& face) {
  return face.x == face.y || face.y == face.z || face.z == face.x;
}

/// How many edges have one face, and how many more than two.
struct EdgeCounts {
  int open = 0, crowded = 0;
};
EdgeCounts count_edges(std::size_t point_count, std::vector<ivec3> faces) {
  std::erase_if(faces, has_equal_corners);
  EdgeCounts counts;
  EdgeTopology(std::move(faces), point_count).for_each_edge([&](std::span<const int> edge) {
    counts.open += edge.size() == 1 ? 1 : 0;
    counts.crowded += edge.size() > 2 ? 1 : 0;
  });
  return counts;
}

void apply(Draft& draft, const std::vector<int>& joined, RepairStep& step) {
  for (std::size_t v = 0; v < joined.size(); ++v) {
    if (at(joined[v]) == v) continue;
    add_place(step, draft.points[v]);
    step.length = std::max(step.length, glm::distance(draft.points[v], draft.points[at(joined[v])]));
  }
  draft.faces = renumbered(draft.faces, joined);
  std::vector<char> removed(draft.faces.size(), 0);
  for (std::size_t f = 0; f < removed.size(); ++f) {
    removed[f] = has_equal_corners(draft.faces[f]) ? 1 : 0;
    step.faces += removed[f];
  }
  remove_faces(draft, removed);
}

}  // namespace

RepairStep join_short_edges(Draft& draft, const RepairLimits& limits) {
  constexpr double kNoise = 1e-9;  // of the diagonal
  RepairStep step = start_step("repair_joined");
  DisjointSets sets(draft.points.size());
  for (int f = 0; f < draft.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      if (glm::distance(draft.corner(f, c), draft.corner(f, (c + 1) % 3)) > kNoise * limits.diagonal) continue;
      sets.unite(draft.faces[at(f)][c], draft.faces[at(f)][(c + 1) % 3]);
    }
  }
  std::vector<int> joined(draft.points.size());
  for (int v = 0; v < draft.point_count(); ++v) joined[at(v)] = sets.find(v);
  apply(draft, joined, step);
  return step;
}

RepairStep join_rims(Draft& draft, const RepairLimits& limits) {
  RepairStep step = start_step("repair_joined");
  const std::vector<int> rim = rim_points(draft);
  if (rim.empty()) return step;
  constexpr int kClosedOfACrowded = 1000;  // closed edges for which one may become an edge of more than two faces
  const EdgeCounts loaded = count_edges(draft.points.size(), draft.faces);
  EdgeCounts best = loaded;
  std::vector<int> best_joined, last = unjoined(draft.points.size());
  // Radii from 1e-7 of the diagonal (at the default) to `join`: a larger one must leave fewer open edges.
  constexpr std::array<double, 8> kRadii{1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4};
  for (const double fraction : kRadii) {
    const double r = limits.join * fraction / kRadii.back();
    if (!(r > 0) || best.open == 0) break;
    std::vector<int> joined = joined_points(draft, rim, r);
    if (joined == last) continue;  // with the same edges as before
    last = joined;
    const EdgeCounts counts = count_edges(draft.points.size(), renumbered(draft.faces, joined));
    const int most_crowded = loaded.crowded + (loaded.open - counts.open) / kClosedOfACrowded;
    if (counts.crowded > most_crowded || counts.open >= best.open) continue;
    best = counts;
    best_joined = std::move(joined);
  }
  if (!best_joined.empty()) apply(draft, best_joined, step);
  return step;
}

// T-junctions: an open edge on which a rim point of other faces lies is split there.

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
