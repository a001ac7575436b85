// Holes: every boundary loop of the surface is filled.
//
// A loop of up to 120 corners gets the triangulation whose sharpest edge is least, and of these the one with the least
// area: for each stretch of the rim from corner i to k, the best triangle (i, m, k) with the best triangulations of
// both sides is kept (Barequet, Sharir 1995; angles of Liepa 2003). This takes O(n^3). Longer loops are filled by
// cutting ears off the projection onto their mean plane, in O(n^2). If the corners cannot be joined without repeating
// an edge, the hole becomes a fan around its middle. A loop that passes a point twice is first divided there.
//
// Pitfall: many triangulations of a plane are equally good, and rounding would choose one by the unit of the file.
// Corners are taken in the unit of the hole and rounded to 2^-30 of it, so the same one is chosen in every unit.
#include <set>
#include <tuple>

#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

/// Cost of a part of a triangulation: first its sharpest edge, then its area. Angles are measured as 1 - cos.
struct Badness {
  double angle = 0, area = 0;
  bool operator<(const Badness& other) const { return std::tie(angle, area) < std::tie(other.angle, other.area); }
};
constexpr double kImpossible = 100;  // more than any angle
constexpr double kFlatTriangle = 10;

/// Dynamic programme over the stretches of rim from corner i to corner k: each is a triangle (i, m, k) and two shorter
/// stretches.
class LeastAngle {
 public:
  explicit LeastAngle(const HoleRim& rim)
      : rim_(rim), n_(static_cast<int>(rim.corners.size())), best_(at(n_ * n_)), middle_(at(n_ * n_), -1) {}

  std::optional<std::vector<ivec3>> solve() {
    for (int length = 2; length < n_; ++length)
      for (int i = 0; i + length < n_; ++i) solve(i, i + length);
    if (best_[index(0, n_ - 1)].angle >= kImpossible) return std::nullopt;
    std::vector<ivec3> triangles;
    collect(0, n_ - 1, triangles);
    return triangles;
  }

 private:
  [[nodiscard]] std::size_t index(int i, int k) const { return at(i * n_ + k); }

  [[nodiscard]] dvec3 unit_normal(int i, int m, int k) const {
    const dvec3 &a = rim_.corners[at(i)], &b = rim_.corners[at(m)], &c = rim_.corners[at(k)];
    const dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    return length > 0 ? n / length : dvec3(0);
  }
  /// Returns the normal across the edge i k of a triangle: of a face outside of the hole, or of a triangle of the
  /// stretch.
  [[nodiscard]] dvec3 normal_across(int i, int k) const {
    return k == i + 1 ? rim_.normals[at(i)] : unit_normal(i, middle_[index(i, k)], k);
  }

  void solve(int i, int k) {
    Badness& best = best_[index(i, k)];
    best.angle = kImpossible;
    const bool whole = i == 0 && k == n_ - 1;
    if (!whole && !rim_.may_join(i, k)) return;
    for (int m = i + 1; m < k; ++m) {
      const Badness &left = best_[index(i, m)], &right = best_[index(m, k)];
      if (left.angle >= kImpossible || right.angle >= kImpossible) continue;
      const dvec3 &a = rim_.corners[at(i)], &b = rim_.corners[at(m)], &c = rim_.corners[at(k)];
      const dvec3 normal = unit_normal(i, m, k);
      Badness now{std::max(left.angle, right.angle), left.area + right.area};
      now.angle = std::max(now.angle, 1 - glm::dot(normal, normal_across(i, m)));
      now.angle = std::max(now.angle, 1 - glm::dot(normal, normal_across(m, k)));
      if (whole) now.angle = std::max(now.angle, 1 - glm::dot(normal, rim_.normals[at(k)]));
      if (is_flat(a, b, c)) now.angle = kFlatTriangle;
      now.area += 0.5 * glm::length(glm::cross(b - a, c - a));
      if (!(now < best)) continue;
      best = now;
      middle_[index(i, k)] = m;
    }
  }

  void collect(int first, int last, std::vector<ivec3>& triangles) const {
    std::vector<std::pair<int, int>> stack{{first, last}};
    while (!stack.empty()) {
      const auto [i, k] = stack.back();
      stack.pop_back();
      if (k <= i + 1) continue;
      const int m = middle_[index(i, k)];
      triangles.emplace_back(i, m, k);
      stack.emplace_back(m, k);
      stack.emplace_back(i, m);
    }
  }

  const HoleRim& rim_;
  int n_;
  std::vector<Badness> best_;
  std::vector<int> middle_;
};

/// The corners in their mean plane (Newell's normal), counter-clockwise.
std::vector<dvec2> project(const std::vector<dvec3>& corners) {
  dvec3 normal{0};
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % n] - corners[0]);
  const double length = glm::length(normal);
  const dvec3 z = length > 0 ? normal / length : dvec3(0, 0, 1);
  const dvec3 x = any_perpendicular(z), y = glm::cross(z, x);
  std::vector<dvec2> flat;
  for (const dvec3& p : corners) flat.emplace_back(glm::dot(p - corners[0], x), glm::dot(p - corners[0], y));
  return flat;
}

double cross(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Ears {
 public:
  explicit Ears(const HoleRim& rim) : rim_(rim), flat_(project(rim.corners)) {
    for (int i = 0; i < static_cast<int>(flat_.size()); ++i) left_.push_back(i);
  }

  std::optional<std::vector<ivec3>> cut_all() {
    std::vector<ivec3> triangles;
    std::size_t from = 0;
    while (left_.size() > 3) {
      const std::size_t ear = find(from);
      if (ear == left_.size()) return std::nullopt;
      triangles.emplace_back(before(ear), left_[ear], after(ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
      from = (ear + 1) % left_.size();  // not next to the last ear: no fans of needles
    }
    triangles.emplace_back(left_[0], left_[1], left_[2]);
    return triangles;
  }

 private:
  [[nodiscard]] int before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  [[nodiscard]] int after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

  /// Returns a convex corner whose triangle contains no other corner, or any convex corner, or any corner.
  [[nodiscard]] std::size_t find(std::size_t from) const {
    for (const int strictness : {2, 1, 0}) {
      for (std::size_t i = 0; i < left_.size(); ++i) {
        const std::size_t ear = (from + i) % left_.size();
        if (!rim_.may_join(before(ear), after(ear))) continue;
        const bool convex = cross(flat_[at(before(ear))], flat_[at(left_[ear])], flat_[at(after(ear))]) > 0;
        if (strictness == 0 || (convex && (strictness == 1 || is_empty(ear)))) return ear;
      }
    }
    return left_.size();
  }
  [[nodiscard]] bool is_empty(std::size_t ear) const {
    const int ia = before(ear), ib = left_[ear], ic = after(ear);
    const dvec2 &a = flat_[at(ia)], &b = flat_[at(ib)], &c = flat_[at(ic)];
    return std::none_of(left_.begin(), left_.end(), [&](int i) {
      const dvec2& p = flat_[at(i)];
      if (i == ia || i == ib || i == ic || p == a || p == b || p == c) return false;
      return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
    });
  }

  const HoleRim& rim_;
  std::vector<dvec2> flat_;
  std::vector<int> left_;
};

}  // namespace

std::optional<std::vector<ivec3>> fill_by_least_angle(const HoleRim& rim) {
  return LeastAngle(rim).solve();
}

std::optional<std::vector<ivec3>> fill_by_ears(const HoleRim& rim) {
  return Ears(rim).cut_all();
}

namespace {

/// Points along a rim with the loaded face's normal outside of each edge.
struct Loop {
  std::vector<int> points;
  std::vector<dvec3> normals;  ///< normal of the face outside of the edge from each point to the next
};

/// Finds the rims in the order of OpenMesh. A rim that passes a point twice is split into rims that touch there.
std::vector<Loop> find_loops(const Draft& draft) {
  const Topology topology = make_topology(draft, pair_half_edges(draft, draft.edges()));
  std::vector<char> seen(topology.mesh.n_halfedges(), 0);
  std::vector<Loop> loops;
  std::vector<int> place_of(draft.points.size(), -1);  // position of a point in the open loop
  for (const OpenMesh::SmartHalfedgeHandle first : topology.mesh.halfedges()) {
    if (!first.is_boundary() || seen[at(first.idx())] != 0) continue;
    Loop open;
    OpenMesh::SmartHalfedgeHandle h = first;
    do {
      seen[at(h.idx())] = 1;
      const int point = topology.vertex_of[at(h.from().idx())];
      if (const int place = place_of[at(point)]; place >= 0) {
        Loop closed;
        closed.points.assign(open.points.begin() + place, open.points.end());
        closed.normals.assign(open.normals.begin() + place, open.normals.end());
        for (const int p : closed.points) place_of[at(p)] = -1;
        open.points.resize(at(place));
        open.normals.resize(at(place));
        loops.push_back(std::move(closed));
      }
      place_of[at(point)] = static_cast<int>(open.points.size());
      open.points.push_back(point);
      const dvec3 normal = draft.area_normal(h.opp().face().idx());
      open.normals.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : dvec3(0));
      h = h.next();
    } while (h != first);
    for (const int p : open.points) place_of[at(p)] = -1;
    loops.push_back(std::move(open));
  }
  // Two open sides of the same edge need no face between them.
  std::erase_if(loops, [](const Loop& loop) { return loop.points.size() < 3; });
  return loops;
}

/// The edges of a draft, and those added later.
class KnownEdges {
 public:
  explicit KnownEdges(const Draft& draft) : first_(draft.edges()) {}
  void add(int a, int b) { made_.emplace(std::min(a, b), std::max(a, b)); }
  [[nodiscard]] bool contains(int a, int b) const {
    return made_.contains({std::min(a, b), std::max(a, b)}) || !first_.edge_between(a, b).empty();
  }

 private:
  EdgeTopology first_;
  std::set<std::pair<int, int>> made_;
};

/// The diameter of the ball about the mean corner that holds all corners [m].
double width_of(const Draft& draft, const Loop& loop, dvec3& middle) {
  middle = dvec3(0);
  for (const int v : loop.points) middle += draft.points[at(v)] / static_cast<double>(loop.points.size());
  double radius = 0;
  for (const int v : loop.points) radius = std::max(radius, glm::distance(draft.points[at(v)], middle));
  return 2 * radius;
}

/// The corners are relative to the hole's middle, in the unit of its width, and rounded to 2^-30 of it, as the normals
/// are: of many triangulations of a plane the same one is the least, whatever the unit of the file.
std::optional<std::vector<ivec3>> triangulate(const Draft& draft, const Loop& loop, const KnownEdges& edges) {
  constexpr std::size_t kMaxLeastAngle = 120, kMaxEars = 20000;
  constexpr double kSteps = 1 << 30;
  if (loop.points.size() > kMaxEars) return std::nullopt;
  dvec3 middle;
  const double width = width_of(draft, loop, middle);
  const auto rounded = [](const dvec3& v) { return glm::round(v * kSteps) / kSteps; };
  HoleRim rim;
  for (const int v : loop.points) rim.corners.push_back(rounded((draft.points[at(v)] - middle) / width));
  for (const dvec3& normal : loop.normals) rim.normals.push_back(rounded(normal));
  rim.may_join = [&](int i, int j) { return !edges.contains(loop.points[at(i)], loop.points[at(j)]); };
  return loop.points.size() <= kMaxLeastAngle ? fill_by_least_angle(rim) : fill_by_ears(rim);
}

/// Fills one hole, by a fan around its middle if its corners cannot be joined otherwise.
void fill(Draft& draft, const Loop& loop, const dvec3& middle, KnownEdges& edges, RepairStep& step) {
  const int first = draft.face_count(), n = static_cast<int>(loop.points.size());
  if (const auto triangles = triangulate(draft, loop, edges)) {
    for (const ivec3& t : *triangles) {
      const ivec3 face(loop.points[at(t.x)], loop.points[at(t.y)], loop.points[at(t.z)]);
      draft.add(face, kFilledFace);
      for (int c = 0; c < 3; ++c) edges.add(face[c], face[(c + 1) % 3]);
    }
  } else {
    const int center = draft.add_point(middle);
    for (int i = 0; i < n; ++i) draft.add({loop.points[at(i)], loop.points[at((i + 1) % n)], center}, kFilledFace);
  }
  for (int f = first; f < draft.face_count(); ++f) step.area += draft.area(f);
  step.faces += draft.face_count() - first;
}

}  // namespace

RepairStep fill_holes(Draft& draft, const RepairLimits& limits) {
  RepairStep step = start_step("repair_filled");
  const std::vector<Loop> loops = find_loops(draft);
  if (loops.empty()) return step;
  KnownEdges edges(draft);
  for (const Loop& loop : loops) {
    dvec3 middle;
    const double width = width_of(draft, loop, middle);
    step.length = std::max(step.length, width);
    if (width > limits.fill) step.severity = Severity::warning;
    add_place(step, middle);
    fill(draft, loop, middle, edges, step);
  }
  return step;
}

}  // namespace taxel
