// Exact geodesic distances from one point, by windows over the unfolded mesh.
//
//          t         A shortest path is straight once the faces that it crosses are laid flat. A window is the part
//         / \        [b, e] of an edge through which one source s is seen: within it the distance of a point t of
//     ---b---e---    the next face is l + |s - t|, with the length l of the path to s. s is the source itself, or a
//         \ /        vertex where paths may bend: a saddle, or the boundary.
//          s
//
// 1. Windows start on the edges of the source's face and lie in buckets by distance. Each is taken across its face,
//    where its rays meet the left edge, the right one or both; the apex gets a distance.
// 2. A vertex with more than a full turn of face around it emits windows into the directions that it shadows.
// 3. A window whose end vertices are reached earlier along the edge is on no shortest path and is dropped (Xin, Wang
//    2009). Windows are not trimmed against each other, and may overlap.
//
// Every window is a path that exists, so late and overlapping windows cost time, never exactness. Pitfalls: rounding
// may leave a gap between two windows, so each offers the apex a path over its nearer end; a source on a vertex has no
// clear directions, so the vertex becomes a source as well. A path is traced back from window to window. Theory:
// docs/theory/mesh.md, "Shortest paths".
#include "core/mesh/geodesic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/math.h"
#include "core/base/parallel.h"

namespace taxel {

UnfoldedMesh::UnfoldedMesh(TriMeshPtr mesh)
    : mesh_(std::move(mesh)), edges_(3 * mesh_->faces().size()), angles_(edges_.size()) {
  lay_flat();
  measure_fans();
  ends_.resize(edges_.size());
  for (int h = 0; h < edge_count(); ++h)
    ends_[at(h)] = {edges_[at(next_edge(h))].apex_fan, edges_[at(previous_edge(h))].apex_fan};
}

void UnfoldedMesh::lay_flat() {
  parallel_chunks(edge_count(), 768, [&](int begin, int end) {
    for (int h = begin; h < end; ++h) {
      const dvec3 &a = mesh_->vertex(h / 3, h % 3), &b = mesh_->vertex(h / 3, (h + 1) % 3),
                  &c = mesh_->vertex(h / 3, (h + 2) % 3);
      FlatEdge& e = edges_[at(h)];
      e.twin = mesh_->topology().twin(h);
      e.length = glm::distance(a, b);
      const double twice_area = glm::length(glm::cross(b - a, c - a));
      e.apex = dvec2(glm::dot(c - a, b - a), twice_area) / e.length;
      e.to_apex = glm::normalize(e.apex);
      e.from_apex = glm::normalize(dvec2(e.length, 0) - e.apex);
      angles_[at(h)].y = std::atan2(twice_area, glm::dot(a - c, b - c));
    }
  });
}

void UnfoldedMesh::measure_fans() {
  VertexFans fans = mesh_->topology().vertex_fans();
  fans_.reserve(at(fans.count()));
  for (int f = 0; f < fans.count(); ++f) {
    const std::span<const int> corners = fans.corners_of(f);
    Fan fan{0.0, mesh_->topology().twin(corners[0]) >= 0, fans.first[at(f)], static_cast<int>(corners.size())};
    for (const int corner : corners) {
      const std::size_t opposite = at(next_edge(corner));
      edges_[opposite].apex_fan = f;
      angles_[opposite].x = fan.angle;
      fan.angle += angles_[opposite].y;
    }
    fans_.push_back(fan);
  }
  corners_ = std::move(fans.corners);
}

dvec2 UnfoldedMesh::flat(int halfedge, const dvec3& p) const {
  const dvec3 &a = mesh_->vertex(halfedge / 3, halfedge % 3), &b = mesh_->vertex(halfedge / 3, (halfedge + 1) % 3);
  const dvec3& n = mesh_->face_normals()[at(halfedge / 3)];
  const dvec3 along = (b - a) / edge(halfedge).length;
  return {glm::dot(p - a, along), glm::dot(p - a, glm::cross(n, along))};
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Windows are processed in the order of their distance up to the width of a bucket (Xu et al. 2015, "Fast wavefront
// propagation"). The order changes only the number of windows that are late when they are processed, not the result.
constexpr int kBuckets = 256;         // number up to the radius, or
constexpr int kBucketsAcross = 2048;  // number along the diagonal of the mesh, if that gives narrower ones
constexpr double kMaxBuckets = 1e6;   // for paths far longer than the diagonal
constexpr double kAtVertex = 1e-9;    // of an edge
constexpr double kTie =
    1.0 - 1e-12;  // far above the rounding of a path's length, far below any difference that matters

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Returns the coordinates of v in the frame whose x axis is the unit vector u.
dvec2 turned(const dvec2& v, const dvec2& u) {
  return {glm::dot(v, u), cross(u, v)};
}

}  // namespace

GeodesicDistance::GeodesicDistance(std::shared_ptr<const UnfoldedMesh> mesh)
    : mesh_(std::move(mesh)),
      first_window_(at(mesh_->edge_count()), -1),
      arrivals_(at(mesh_->fan_count())),
      face_reached_(mesh_->mesh().faces().size(), 0),
      buckets_(at(kBuckets) + 1) {}

void GeodesicDistance::reset() {
  for (const int h : touched_edges_) first_window_[at(h)] = -1;
  for (const int f : touched_fans_) arrivals_[at(f)] = Arrival{};
  for (const int f : reached_) face_reached_[at(f)] = 0;
  touched_edges_.clear();
  touched_fans_.clear();
  reached_.clear();
  windows_.clear();
}

void GeodesicDistance::propagate(int face, const dvec3& source, double radius) {
  reset();
  radius_ = radius;
  const double extent = mesh_->mesh().bounds().diagonal();
  buckets_per_metre_ = std::max(kBuckets / radius, kBucketsAcross / extent);
  bucket_ = 0;
  start(face, source);
  drain_buckets();
}

/// Straight lines lead from the source to the three corners of its face and into the faces across the three edges. A
/// path over a vertex very near to the source is never too short, and too long by no more than twice their distance.
void GeodesicDistance::start(int face, const dvec3& source) {
  source_face_ = face;
  source_ = mesh_->flat(3 * face, source);
  touch_face(face);
  for (int h = 3 * face; h < 3 * face + 3; ++h) {
    const FlatEdge& edge = mesh_->edge(h);
    const dvec2 p = mesh_->flat(h, source);
    const double to_apex = glm::distance(p, edge.apex);
    arrive(h, to_apex, p);
    if (to_apex <= kAtVertex * edge.length) {
      const UnfoldedMesh::Fan& fan = mesh_->fan(edge.apex_fan);
      for (int i = fan.first; i < fan.first + fan.count; ++i) {
        const int corner = mesh_->corners()[at(i)];
        emit_through(corner, 0.0, mesh_->apex_angle(next_edge(corner)), to_apex);
      }
    }
    add_window(edge.twin, 0.0, edge.length, dvec2(edge.length - p.x, -p.y), 0.0);
  }
}

void GeodesicDistance::drain_buckets() {
  for (; bucket_ < buckets_.size(); ++bucket_) {
    while (!buckets_[bucket_].empty()) {
      const int item = buckets_[bucket_].back();
      buckets_[bucket_].pop_back();
      if (item >= 0) {
        process(item);
      } else {
        emit(~item);
      }
    }
  }
}

void GeodesicDistance::schedule(int item, double distance) {
  const auto by_distance = static_cast<std::size_t>(std::min(distance * buckets_per_metre_, kMaxBuckets));
  const std::size_t bucket = std::max(bucket_, by_distance);  // not an earlier one, which rounding could give
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back(item);
}

void GeodesicDistance::process(int window) {
  const GeodesicWindow w = windows_[at(window)];  // a copy, because more windows are added below
  if (!is_late(w)) pass_face(w);
}

/// Returns true if every point of the window is reached earlier along the edge from one of its ends. If the far end of
/// the window is, so is every point between, by the triangle inequality (Xin, Wang 2009, theorem 3.2). Such a window is
/// on no shortest path. Ties up to rounding are not late: windows through a vertex very near to their source tie.
bool GeodesicDistance::is_late(const GeodesicWindow& w) const {
  const UnfoldedMesh::Ends& ends = mesh_->ends(w.halfedge);
  const double to_end = w.distance(w.end), to_begin = w.distance(w.begin);
  return arrivals_[at(ends.start)].distance + w.end < kTie * to_end ||
         arrivals_[at(ends.end)].distance + (mesh_->edge(w.halfedge).length - w.begin) < kTie * to_begin;
}

/// Unfolds the next face. The rays through the window intersect its left edge, its right edge, or both, with the apex
/// between them.
void GeodesicDistance::pass_face(const GeodesicWindow& w) {
  const FlatEdge& edge = mesh_->edge(w.halfedge);
  const dvec2 s = w.source, to_apex = edge.apex - s;
  // > 0: the apex lies left of the ray through the window's begin, its end.
  const double side_of_begin = (w.begin - s.x) * to_apex.y + s.y * to_apex.x;
  const double side_of_end = (w.end - s.x) * to_apex.y + s.y * to_apex.x;
  reach_apex(w, edge, side_of_begin, side_of_end);
  // The fraction of an edge at which a ray intersects it: cross products measure the distances of its ends to the ray.
  const auto part = [](double before, double after) { return before > 0.0 ? before / (before + after) : 0.0; };
  if (side_of_begin < 0.0) {
    const FlatEdge& left = mesh_->edge(previous_edge(w.halfedge));
    const double lo = part(-s.y * w.begin, -side_of_begin);
    const double hi = side_of_end < 0.0 ? part(-s.y * w.end, -side_of_end) : 1.0;
    add_window(left.twin, lo * left.length, hi * left.length, turned(s, edge.to_apex), w.offset);
  }
  if (side_of_end > 0.0) {
    const FlatEdge& right = mesh_->edge(next_edge(w.halfedge));
    const double lo = side_of_begin > 0.0 ? part(side_of_begin, -s.y * (edge.length - w.begin)) : 0.0;
    const double hi = part(side_of_end, -s.y * (edge.length - w.end));
    add_window(right.twin, lo * right.length, hi * right.length, turned(-to_apex, edge.from_apex), w.offset);
  }
}

/// The path to the apex is straight if the apex is visible through the window. Otherwise it bends at the nearer end.
void GeodesicDistance::reach_apex(const GeodesicWindow& w, const FlatEdge& edge, double side_of_begin,
                                  double side_of_end) {
  const Arrival& arrival = arrivals_[at(edge.apex_fan)];
  const double straight = w.offset + glm::distance(w.source, edge.apex);
  if (!(straight < arrival.distance)) return;
  if (side_of_begin <= 0.0 && side_of_end >= 0.0) {
    arrive(w.halfedge, straight, w.source);
  } else {
    const dvec2 bend(side_of_begin > 0.0 ? w.begin : w.end, 0.0);
    arrive(w.halfedge, w.distance(bend.x) + glm::distance(bend, edge.apex), bend);
  }
}

void GeodesicDistance::arrive(int opposite, double distance, const dvec2& from) {
  const int fan = mesh_->edge(opposite).apex_fan;
  Arrival& arrival = arrivals_[at(fan)];
  if (!(distance < arrival.distance) || distance > radius_) return;
  if (arrival.distance == kInfinity) touched_fans_.push_back(fan);
  arrival.distance = distance;
  arrival.opposite = opposite;
  arrival.from = from;
  if (mesh_->fan(fan).bends()) schedule(~fan, distance);
}

/// A vertex becomes a source for the directions that make at least half a turn with the arriving path, on either side
/// (Mitchell, Mount, Papadimitriou 1987, lemma 3.4).
void GeodesicDistance::emit(int fan_index) {
  Arrival& arrival = arrivals_[at(fan_index)];
  if (!(arrival.distance < arrival.emitted)) return;  // a longer path was scheduled earlier
  arrival.emitted = arrival.distance;
  const double offset = arrival.distance;
  const UnfoldedMesh::Fan& fan = mesh_->fan(fan_index);
  const FlatEdge& last = mesh_->edge(arrival.opposite);
  // Directions by their angle from the fan's first edge. The apex sees the edge from its end to its start.
  const dvec2 to_start = -last.apex, back = arrival.from - last.apex;
  const double came_from =
      mesh_->angle_before(arrival.opposite) + std::atan2(cross(to_start, back), glm::dot(to_start, back));
  double wedges[2][2];
  if (fan.closed) {
    wedges[0][0] = came_from + kPi, wedges[0][1] = came_from + fan.angle - kPi;
    wedges[1][0] = wedges[0][0] - fan.angle, wedges[1][1] = wedges[0][1] - fan.angle;
  } else {
    wedges[0][0] = 0.0, wedges[0][1] = came_from - kPi;
    wedges[1][0] = came_from + kPi, wedges[1][1] = fan.angle;
  }
  for (int i = fan.first; i < fan.first + fan.count; ++i) {
    const int corner = mesh_->corners()[at(i)];
    const double before = mesh_->angle_before(next_edge(corner)), width = mesh_->apex_angle(next_edge(corner));
    for (const auto& wedge : wedges) {
      const double lo = wedge[0] - before, hi = wedge[1] - before;
      if (hi >= 0.0 && lo <= width && lo <= hi) emit_through(corner, lo, hi, offset);
    }
  }
}

/// Emits from the vertex at which the half-edge `corner` begins, across its face, between two directions, given as
/// angles from that half-edge. If the directions include one of the two edges at the vertex, a path runs along it.
void GeodesicDistance::emit_through(int corner, double lo, double hi, double offset) {
  const int across = next_edge(corner);
  const FlatEdge &edge = mesh_->edge(corner), &opposite = mesh_->edge(across),
                 &last = mesh_->edge(previous_edge(corner));
  touch_face(corner / 3);
  // The point of the opposite edge in a direction, by cross products with the ends of that edge.
  const auto intersect = [&](double angle) {
    const dvec2 ray(std::cos(angle), std::sin(angle));
    const double before = ray.y * edge.length, after = cross(ray, edge.apex);
    return after > 0.0 ? opposite.length * before / (before + after) : opposite.length;
  };
  const bool first_edge = lo <= 0.0, second_edge = hi >= mesh_->apex_angle(across);
  arrive(previous_edge(corner), offset + edge.length, dvec2(last.length, 0.0));
  arrive(corner, offset + last.length, dvec2(0));
  const double begin = first_edge ? 0.0 : intersect(lo), end = second_edge ? opposite.length : intersect(hi);
  // In the face across, the edge runs the other way.
  add_window(opposite.twin, opposite.length - end, opposite.length - begin,
             dvec2(opposite.length - opposite.apex.x, -opposite.apex.y), offset);
}

void GeodesicDistance::add_window(int halfedge, double begin, double end, const dvec2& source, double offset) {
  if (halfedge < 0 || !(end > begin)) return;
  GeodesicWindow w{begin, end, dvec2(source.x, std::min(source.y, 0.0)), offset, halfedge, -1};
  const double nearest = w.distance(std::clamp(source.x, begin, end));
  if (!(nearest <= radius_)) return;
  int& first = first_window_[at(halfedge)];
  if (first < 0) {
    touched_edges_.push_back(halfedge);
    touch_face(halfedge / 3);
  }
  w.next = first;
  first = window_count();
  schedule(first, nearest);
  windows_.push_back(w);
}

void GeodesicDistance::touch_face(int face) {
  if (face_reached_[at(face)] != 0) return;
  face_reached_[at(face)] = 1;
  reached_.push_back(face);
}

double GeodesicDistance::to(int face, const dvec3& target) const {
  double best = kInfinity;
  if (face_reached_[at(face)] == 0) return best;
  if (face == source_face_) best = within_source_face(target);
  best = shortest_in_face(
      *mesh_, face, target, best, [&](int h) { return at_apex(h); },
      [&](int h, const auto& f) { for_each_window(h, f); });
  return best <= radius_ ? best : kInfinity;
}

GeodesicMap::GeodesicMap(std::shared_ptr<const UnfoldedMesh> mesh, const GeodesicDistance& from, const dvec3& source)
    : mesh_(std::move(mesh)),
      radius_(from.radius()),
      source_face_(from.source_face()),
      source_(mesh_->flat(3 * from.source_face(), source)) {
  std::vector<int> reached = from.reached_faces();
  std::sort(reached.begin(), reached.end());
  windows_.reserve(static_cast<std::size_t>(from.window_count()));
  for (const int face : reached) {
    Face& kept = faces_.emplace_back();
    kept.face = face;
    for (std::size_t c = 0; c < 3; ++c) {
      const int h = 3 * face + static_cast<int>(c);
      kept.at_apex[c] = from.at_apex(h);
      kept.windows[c] = static_cast<std::uint32_t>(windows_.size());
      from.for_each_window(h, [&](const GeodesicWindow& w) { windows_.push_back(w); });
    }
    kept.windows[3] = static_cast<std::uint32_t>(windows_.size());
  }
}

double GeodesicMap::to(int face, const dvec3& target) const {
  const auto found =
      std::lower_bound(faces_.begin(), faces_.end(), face, [](const Face& f, int number) { return f.face < number; });
  if (found == faces_.end() || found->face != face) return kInfinity;
  const double straight = face == source_face_ ? glm::distance(source_, mesh_->flat(3 * face, target)) : kInfinity;
  const auto corner = [&](int h) { return static_cast<std::size_t>(h - 3 * face); };
  const double best = shortest_in_face(
      *mesh_, face, target, straight, [&](int h) { return found->at_apex[corner(h)]; },
      [&](int h, const auto& f) {
        for (std::uint32_t i = found->windows[corner(h)]; i < found->windows[corner(h) + 1]; ++i) f(windows_[i]);
      });
  return best <= radius_ ? best : kInfinity;
}

namespace {

constexpr double kAtSource = 1e-9;   // of the path's length
constexpr int kMaxStepsPerEdge = 4;  // more than any path has; ends a loop that rounding might cause

/// Traces the path from the target back to the source.
class Tracer {
 public:
  Tracer(const UnfoldedMesh& mesh, const GeodesicDistance& from, int face, const dvec3& target)
      : mesh_(mesh), from_(from), face_(face), at_(target), slack_(kAtSource * from.to(face, target)) {}

  /// Traces one piece and appends its points, but not the source. Returns false if the rest is straight to the source.
  bool step(std::vector<dvec3>& path) { return vertex_ >= 0 ? leave_vertex(path) : cross_face(path); }

 private:
  [[nodiscard]] dvec3 corner(int halfedge) const { return mesh_.mesh().vertex(halfedge / 3, halfedge % 3); }
  /// Returns the point at the distance x along a half-edge.
  [[nodiscard]] dvec3 on_edge(int halfedge, double x) const {
    return glm::mix(corner(halfedge), corner(next_edge(halfedge)), x / mesh_.edge(halfedge).length);
  }
  [[nodiscard]] dvec3 apex(int halfedge) const { return corner(previous_edge(halfedge)); }

  void go_over(int halfedge, double x, std::vector<dvec3>& path) {
    at_ = on_edge(halfedge, x);
    path.push_back(at_);
    vertex_ = -1;
    entered_ = mesh_.edge(halfedge).twin;
    face_ = entered_ / 3;
  }
  void go_to_vertex(int opposite, std::vector<dvec3>& path) {
    vertex_ = opposite;
    at_ = apex(opposite);
    if (path.back() != at_) path.push_back(at_);
  }
  bool cross_face(std::vector<dvec3>& path);
  bool leave_vertex(std::vector<dvec3>& path);

  const UnfoldedMesh& mesh_;
  const GeodesicDistance& from_;
  int face_;
  dvec3 at_;
  double slack_;
  int entered_ = -1;  ///< half-edge over which the face was entered; the path does not go back over it
  int vertex_ = -1;   ///< half-edge with the present vertex as apex, or -1 within a face or edge
};

/// The path to a point of a face comes over one of its edges, through the window with the least distance, or from one
/// of its corners.
bool Tracer::cross_face(std::vector<dvec3>& path) {
  double best = std::numeric_limits<double>::infinity(), x = 0;
  int over = -1, corner_of = -1;
  for (int h = 3 * face_; h < 3 * face_ + 3; ++h) {
    const dvec2 t = mesh_.flat(h, at_);
    const double to_corner = glm::distance(t, mesh_.edge(h).apex), by_corner = from_.at_apex(h) + to_corner;
    if (to_corner <= slack_) {  // at a vertex, whose path is known, while its faces may lack windows
      go_to_vertex(h, path);
      return true;
    }
    if (by_corner < best) {
      best = by_corner;
      corner_of = h;
      over = -1;
    }
    if (h == entered_) continue;
    from_.for_each_window(h, [&](const GeodesicWindow& w) {
      const double height = t.y - w.source.y;
      const double straight = height > 0 ? w.source.x - (t.x - w.source.x) * w.source.y / height : t.x;
      const double crossing = std::clamp(straight, w.begin, w.end);
      const double length = w.distance(crossing) + glm::distance(dvec2(crossing, 0), t);
      // A tie goes to the window: the path then only touches the corner.
      if (length > best || (length == best && over >= 0)) return;
      best = length;
      x = crossing;
      over = h;
      corner_of = -1;
    });
  }
  if (face_ == from_.source_face() && from_.within_source_face(at_) <= best + slack_) return false;
  if (over >= 0) {
    go_over(over, x, path);
  } else {
    go_to_vertex(corner_of, path);
  }
  return true;
}

bool Tracer::leave_vertex(std::vector<dvec3>& path) {
  const GeodesicDistance::LastPart last = from_.last_part(vertex_);
  const int opposite = last.opposite;
  if (from_.at_apex(vertex_) <= slack_) return false;
  const FlatEdge& edge = mesh_.edge(opposite);
  if (opposite / 3 == from_.source_face() &&
      from_.within_source_face(apex(opposite)) <= from_.at_apex(opposite) + slack_)
    return false;
  if (last.from.y >= 0 && last.from.x == 0) {  // along an edge, from the vertex where it begins
    go_to_vertex(next_edge(opposite), path);
  } else if (last.from.y >= 0 && last.from.x == edge.length) {
    go_to_vertex(previous_edge(opposite), path);
  } else {
    const double part = edge.apex.y / (edge.apex.y - last.from.y);
    go_over(opposite, std::clamp(glm::mix(edge.apex.x, last.from.x, part), 0.0, edge.length), path);
  }
  return true;
}

}  // namespace

std::vector<dvec3> geodesic_path(const UnfoldedMesh& mesh, const GeodesicDistance& from, const dvec3& source, int face,
                                 const dvec3& target) {
  if (!std::isfinite(from.to(face, target))) return {};
  std::vector<dvec3> path{target};
  Tracer tracer(mesh, from, face, target);
  for (int i = 0; i < kMaxStepsPerEdge * mesh.edge_count() && tracer.step(path); ++i) {
  }
  path.push_back(source);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace taxel
