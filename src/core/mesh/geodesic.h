// Exact geodesic distances and paths on a mesh from one point up to a radius, by windows: Mitchell, Mount,
// Papadimitriou 1987 ("The discrete geodesic problem") for windows and pseudo-sources, Xin, Wang 2009 ("Improving Chen
// and Han's algorithm on the discrete geodesic problem") for the choice of windows to drop. GeodesicDistance
// propagates, GeodesicMap keeps a compact copy of the result, and geodesic_path() traces a path back.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A triangle laid flat on one of its edges, which runs from (0, 0) to (length, 0) with the third corner above it.
struct FlatEdge {
  double length = 0;   ///< length of the edge [m]
  dvec2 apex{0};       ///< third corner [m]
  dvec2 to_apex{0};    ///< unit vector from the edge's start to the apex
  dvec2 from_apex{0};  ///< unit vector from the apex to the edge's end
  int twin = -1;       ///< the edge in the face across, or -1 if the surface ends there
  int apex_fan = -1;   ///< fan of the apex in VertexFans
};

/// Half-edge h = 3 face + c runs from corner c of the face to corner c + 1. Vertices are the fans of faces around them:
/// where an edge is not an inner one (EdgeKind), or fans touch in one vertex, the mesh is cut open and no path passes.
/// Immutable; O(n).
class UnfoldedMesh {
 public:
  explicit UnfoldedMesh(TriMeshPtr mesh);

  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const FlatEdge& edge(int halfedge) const { return edges_[static_cast<std::size_t>(halfedge)]; }
  [[nodiscard]] int edge_count() const { return static_cast<int>(edges_.size()); }
  /// The fans at both ends of a half-edge, stored together so that one memory access finds them.
  struct Ends {
    int start = -1, end = -1;
  };
  [[nodiscard]] const Ends& ends(int halfedge) const { return ends_[static_cast<std::size_t>(halfedge)]; }

  struct Fan {
    double angle = 0;    ///< sum of the angles of its faces [rad]
    bool closed = true;  ///< true for a ring of faces, false for a row from boundary to boundary
    int first = 0;       ///< the fan has corners()[first .. first + count), counter-clockwise
    int count = 0;
    /// Shortest paths may bend here: at saddles and at the boundary (Mitchell, Mount, Papadimitriou 1987, lemma 3.4).
    [[nodiscard]] bool bends() const { return !closed || angle > 2.0 * kPi; }
  };
  [[nodiscard]] const Fan& fan(int fan) const { return fans_[static_cast<std::size_t>(fan)]; }
  [[nodiscard]] int fan_count() const { return static_cast<int>(fans_.size()); }
  /// Half-edges that begin at the vertex of a fan, one per face.
  [[nodiscard]] const std::vector<int>& corners() const { return corners_; }
  /// The angle at the apex of a half-edge between the first edge of the apex's fan and the half-edge's face [rad].
  [[nodiscard]] double angle_before(int halfedge) const { return angles_[static_cast<std::size_t>(halfedge)].x; }
  /// The angle of the half-edge's face at the apex [rad].
  [[nodiscard]] double apex_angle(int halfedge) const { return angles_[static_cast<std::size_t>(halfedge)].y; }

  /// Returns a point of the half-edge's face in the flat frame of the half-edge.
  [[nodiscard]] dvec2 flat(int halfedge, const dvec3& p) const;

 private:
  void lay_flat();
  void measure_fans();

  TriMeshPtr mesh_;
  std::vector<FlatEdge> edges_;
  std::vector<Ends> ends_;
  std::vector<Fan> fans_;
  std::vector<int> corners_;
  std::vector<dvec2> angles_;
};

/// A part of a half-edge with the source that is visible in a straight line through it once the faces between are
/// unfolded. All is in the flat frame of the half-edge: the edge along x, the face that the paths enter above it, the
/// source on or below it.
struct GeodesicWindow {
  double begin = 0, end = 0;  ///< along the edge, end > begin [m]
  dvec2 source{0};            ///< unfolded source, or the last vertex at which the path bends [m]
  double offset = 0;          ///< length of the path up to `source` [m]
  int halfedge = -1;
  int next = -1;  ///< next window on the same half-edge, or -1

  /// Returns the length of the path to the point x of the edge [m].
  [[nodiscard]] double distance(double x) const {
    const double dx = x - source.x;
    return offset + std::sqrt(dx * dx + source.y * source.y);
  }
};

/// Returns the length of the shortest path through windows and corners to the point `target` of a face, or `best` if
/// that is less. corner(h) is the distance of the apex of half-edge h; windows(h, f) calls f with every window on h.
template <class Corner, class Windows>
double shortest_in_face(const UnfoldedMesh& mesh, int face, const dvec3& target, double best, const Corner& corner,
                        const Windows& windows) {
  for (int h = 3 * face; h < 3 * face + 3; ++h) {
    const dvec2 t = mesh.flat(h, target);
    best = std::min(best, corner(h) + glm::distance(t, mesh.edge(h).apex));
    windows(h, [&](const GeodesicWindow& w) {
      const double straight = w.offset + glm::distance(w.source, t);
      if (!(straight < best)) return;
      const double height = t.y - w.source.y;
      const double crossing = height > 0.0 ? w.source.x - (t.x - w.source.x) * w.source.y / height : t.x;
      const double x = std::clamp(crossing, w.begin, w.end);
      best = std::min(best, x == crossing ? straight : w.distance(x) + glm::distance(dvec2(x, 0.0), t));
    });
  }
  return best;
}

/// Distances from one source at a time. Retains its memory, so that later calls allocate none. One per thread.
class GeodesicDistance {
 public:
  explicit GeodesicDistance(std::shared_ptr<const UnfoldedMesh> mesh);

  /// Propagates from any point of a face: inside, on an edge or on a vertex. `radius` > 0 may be infinite.
  /// Time and memory grow with the number of windows, 5 to 7 per edge within the radius on a fingertip of 5000 faces.
  void propagate(int face, const dvec3& source, double radius);

  /// The face of the source and all faces with points within the radius, each once, in no particular order.
  [[nodiscard]] const std::vector<int>& reached_faces() const { return reached_; }
  /// Returns the length of the shortest path on the surface to a point of a face [m], to within rounding, or infinity
  /// if it is beyond the radius or no path exists.
  [[nodiscard]] double to(int face, const dvec3& target) const;

  [[nodiscard]] double radius() const { return radius_; }
  /// Returns the length of the straight path to a point of the source's own face [m].
  [[nodiscard]] double within_source_face(const dvec3& target) const {
    return glm::distance(source_, mesh_->flat(3 * source_face_, target));
  }
  [[nodiscard]] int source_face() const { return source_face_; }
  /// Returns the length of the shortest path to the apex of a half-edge [m], or infinity if none is known.
  [[nodiscard]] double at_apex(int halfedge) const {
    return arrivals_[static_cast<std::size_t>(mesh_->edge(halfedge).apex_fan)].distance;
  }
  /// The last part of the shortest path to the apex of a half-edge. It leads through the face of `opposite`, which has
  /// the same apex, from the point `from` in the flat frame of `opposite`, on that half-edge or below it. Valid only if
  /// at_apex() is finite.
  struct LastPart {
    int opposite = -1;
    dvec2 from{0};
  };
  [[nodiscard]] LastPart last_part(int halfedge) const {
    const Arrival& arrival = arrivals_[static_cast<std::size_t>(mesh_->edge(halfedge).apex_fan)];
    return {arrival.opposite, arrival.from};
  }
  /// Calls f with each window on a half-edge.
  template <class F>
  void for_each_window(int halfedge, const F& f) const {
    for (int i = first_window_[static_cast<std::size_t>(halfedge)]; i >= 0;
         i = windows_[static_cast<std::size_t>(i)].next)
      f(windows_[static_cast<std::size_t>(i)]);
  }

  /// The number of windows of the last propagation, a measure of its cost.
  [[nodiscard]] int window_count() const { return static_cast<int>(windows_.size()); }

 private:
  /// The shortest path so far to a vertex (a fan).
  struct Arrival {
    double distance = std::numeric_limits<double>::infinity();
    double emitted = std::numeric_limits<double>::infinity();  ///< distance at which it last became a source itself
    int opposite = -1;  ///< half-edge of the path's last face with the vertex as apex
    dvec2 from{0};      ///< point of the path's last part, in the flat frame of `opposite`
  };

  void reset();
  void start(int face, const dvec3& source);
  void drain_buckets();
  void process(int window);
  [[nodiscard]] bool is_late(const GeodesicWindow& window) const;
  void pass_face(const GeodesicWindow& window);
  void reach_apex(const GeodesicWindow& window, const FlatEdge& edge, double side_of_begin, double side_of_end);
  void arrive(int opposite, double distance, const dvec2& from);
  void emit(int fan);
  void emit_through(int corner, double lo, double hi, double offset);
  void add_window(int halfedge, double begin, double end, const dvec2& source, double offset);
  void schedule(int item, double distance);
  void touch_face(int face);

  std::shared_ptr<const UnfoldedMesh> mesh_;
  double radius_ = 0.0, buckets_per_metre_ = 0.0;
  int source_face_ = -1;
  dvec2 source_{0};  ///< source in the frame of the first half-edge of source_face_

  std::vector<GeodesicWindow> windows_;
  std::vector<int> first_window_;  ///< newest window of each half-edge, or -1
  std::vector<int> touched_edges_;
  std::vector<Arrival> arrivals_;  ///< parallel to the fans
  std::vector<int> touched_fans_;
  std::vector<char> face_reached_;
  std::vector<int> reached_;
  std::vector<std::vector<int>> buckets_;  ///< pending windows (>= 0) and vertices (~fan) by distance
  std::size_t bucket_ = 0;                 ///< bucket that is being emptied
};

/// Distances from the source of one propagation. Immutable; safe to share between threads.
class GeodesicMap {
 public:
  GeodesicMap() = default;
  /// Copies the result of the last propagation of `from`, about 50 bytes per window.
  GeodesicMap(std::shared_ptr<const UnfoldedMesh> mesh, const GeodesicDistance& from, const dvec3& source);

  /// Returns the same bits as GeodesicDistance::to.
  [[nodiscard]] double to(int face, const dvec3& target) const;

 private:
  struct Face {
    int face = -1;
    std::array<double, 3> at_apex{};         ///< distance of the apex of each half-edge [m]
    std::array<std::uint32_t, 4> windows{};  ///< half-edge c has the windows [windows[c], windows[c + 1])
  };
  std::shared_ptr<const UnfoldedMesh> mesh_;
  std::vector<Face> faces_;  ///< reached faces, ascending
  std::vector<GeodesicWindow> windows_;
  double radius_ = 0;
  int source_face_ = -1;
  dvec2 source_{0};
};

/// Returns the path from `source`, the source of the last propagation, to a point of a face: the ends of straight
/// pieces, each within one face. The length is from.to(face, target) to within rounding. Empty if the target was not
/// reached.
std::vector<dvec3> geodesic_path(const UnfoldedMesh& mesh, const GeodesicDistance& from, const dvec3& source, int face,
                                 const dvec3& target);

}  // namespace taxel
