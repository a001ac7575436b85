#include "core/mesh/geodesic/geodesic_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace taxel {
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
