// Holes: every boundary loop of the surface is filled.
#include <set>

#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/steps/hole_fill.h"
#include "core/mesh/repair/steps/parted.h"

namespace taxel {
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
