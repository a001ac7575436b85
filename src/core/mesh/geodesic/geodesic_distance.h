// Exact geodesic distances on a mesh from one point up to a radius, by windows: Mitchell, Mount, Papadimitriou 1987
// ("The discrete geodesic problem") for windows and pseudo-sources, Xin, Wang 2009 ("Improving Chen and Han's algorithm
// on the discrete geodesic problem") for the choice of windows to drop.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/geodesic/unfolded_mesh.h"

namespace taxel {

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

}  // namespace taxel
