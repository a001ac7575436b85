// Output of the kernel: converts polygons in the coordinates of a triangle into polygons of a contact surface in the
// frame of body A, and weighs those that may be back faces of thin bodies.
#pragma once

#include "core/base/math.h"
#include "core/hydro/contact_surface.h"
#include "core/hydro/kernel/covered_region.h"

namespace taxel {

// Back faces of a contact surface: polygons that oppose the pressure, such as the far face of a thin plate.
//
//      skin  ------------------------------      the pressure grows downward
//                 ___________ far face           its pressure would push the plate inward: left out
//        plate   |___________|
//                             near face          its pressure pushes the skin: counts
//
// A body that is thinner than its depth is wholly inside of the field. If both of its faces counted, it would feel the
// difference of two pressures, E t/H, instead of E d/H. A polygon counts by a factor w of the angle between its normal,
// which leads into the soft body, and the gradient of that body's pressure. w is 1 up to kFrontCosine, 0 from
// kBackCosine on, and smooth in between, so that a body that turns feels no jump. Pressure, gradient and everything
// that is computed from them contain w; polygons with w = 0 are left out.

/// Names one of the two bodies of a contact surface.
enum class BodyOfPair { a, b };

/// Cosines of the angles at which w begins to fall and is 0: 102.7 and 122.7 degrees, about the 5 pi/8 = 112.5 degrees
/// beyond which Drake leaves polygons out. Angles that are nearer to each other make larger steps where a body turns,
/// and a first angle nearer to 90 degrees touches walls along the gradient (docs/decisions/contact.md).
inline constexpr double kFrontCosine = -0.22, kBackCosine = -0.54;

/// Returns true if the factor of a polygon is less than 1. `along` is the product of the gradient and the unit normal,
/// and is negative.
inline bool is_back_face(double along, const dvec3& gradient) {
  return along * along > kFrontCosine * kFrontCosine * glm::dot(gradient, gradient);
}

/// Returns the factor w of a polygon with the unit normal n, which leads into the soft body, and the gradient of the
/// body's pressure: 1 without gradient.
inline double front_weight(const dvec3& n, const dvec3& gradient) {
  const double along = glm::dot(n, gradient);
  if (along >= 0 || !is_back_face(along, gradient)) return 1;
  const double cosine = along / glm::length(gradient);
  const double t = std::max(0.0, (cosine - kBackCosine) / (kFrontCosine - kBackCosine));
  return t * t * (3 - 2 * t);
}

/// Whether a contact surface may have back faces.
struct BackFaces {
  bool any = false;  ///< a polygon so far may be a back face; false if all are front faces
  /// Records a polygon. `along` is the product of a body's pressure gradient and the polygon's unit normal that leads
  /// into the body.
  void note(double along, const dvec3& gradient) {
    if (along < 0 && is_back_face(along, gradient)) any = true;
  }
};

/// Distance below which vertices are merged, as a fraction of the source's size. Area, centroid and pressure are
/// computed before merging, so merging does not change the force.
inline constexpr double kMergeDistance = 1e-6;
/// Area below which a polygon is rejected as "sliver", as a fraction of the square of the source's size.
inline constexpr double kSliverArea = 1e-12;
/// Area below which a polygon is only a rounding error, as a fraction of the square of the source's size: triangle and
/// tet touch in an edge or a corner, and nothing is lost.
inline constexpr double kNoArea = 1e-16;
/// Pressure below which a polygon is in the skin and rejected as "touching", as a fraction of the growth of the
/// pressure over the source's size.
inline constexpr double kTouchingPressure = 1e-12;

/// A pressure that is linear in space, frame S: p(x) = dot(gradient, x) + constant.
struct LinearPressure {
  dvec3 gradient{0};    ///< [Pa/m]
  double constant = 0;  ///< [Pa]
};

/// A linear pressure in the coordinates of a triangle: p(u, v) = p0 + u pu + v pv [Pa].
struct PlanePressure {
  double p0 = 0, pu = 0, pv = 0;
  [[nodiscard]] double at(double u, double v) const { return p0 + u * pu + v * pv; }
};

/// The source of a polygon: tets and face.
struct PolygonSource {
  int tet = -1, face = -1;
  double size = 0;  ///< scale of tolerances [m]: size of the tet, or of the triangle without a tet
  int tet_b = -1;   ///< tet of body B if both bodies are soft
};

/// Metric of a triangle's coordinates. The squared length of a step (du, dv) is uu du^2 + 2 uv du dv + vv dv^2 [m^2].
struct PlaneMetric {
  double uu = 0, uv = 0, vv = 0;
};

/// A triangle from which polygons are clipped: x = x0 + u (x1 - x0) + v (x2 - x0), counter-clockwise about its normal.
struct SurfaceTriangle {
  std::array<dvec3, 3> x_S;           ///< corners, frame S of the field
  dvec3 origin_A{0}, u_A{0}, v_A{0};  ///< x0 and the two edges from it, frame A
  dvec3 push_A{0};                    ///< unit direction in which the surface pushes A
  double area = 0;                    ///< [m^2]
  PlaneMetric metric;
  [[nodiscard]] dvec3 point_A(double u, double v) const { return origin_A + u * u_A + v * v_A; }
};

/// A convex polygon in the coordinates of a triangle.
struct PolygonInPlane {
  const double *u = nullptr, *v = nullptr;
  int count = 0;
};

class SurfaceWriter {
 public:
  /// Clears `out`. X_AS is the pose of the frame S in A. If `reverse` is true, the surface pushes A against the
  /// triangles' normals, and the order of vertices is reversed. `field` is the body whose gradients polygons get.
  SurfaceWriter(ContactSurface& out, const RigidTransform& X_AS, bool reverse, BodyOfPair field);

  /// Returns the triangle with these corners and this unit normal.
  [[nodiscard]] SurfaceTriangle triangle(const std::array<dvec3, 3>& x_S, const dvec3& normal_S) const;

  [[nodiscard]] dvec3 point_A(const dvec3& x_S) const { return same_frame_ ? x_S : X_AS_(x_S); }
  [[nodiscard]] dvec3 point_S(const dvec3& x_A) const { return same_frame_ ? x_A : X_AS_.inverse_point(x_A); }
  /// Returns the pose of S in A, or null if the two frames are the same.
  [[nodiscard]] const RigidTransform* X_AS() const { return same_frame_ ? nullptr : &X_AS_; }
  /// Returns true if vertices must be written in reverse order.
  [[nodiscard]] bool reverse() const { return reverse_; }
  /// Room for eight vertices [frame A, m] and their pressures [Pa], of the polygon that close() adds next.
  struct Slots {
    dvec3* vertices;
    double* pressure;
  };
  [[nodiscard]] Slots slots() {
    if (out_.vertices.size() < used_ + kSlots) make_room();
    return {out_.vertices.data() + used_, out_.pressure.data() + used_};
  }
  /// Adds the polygon whose first `count` vertices are in slots().
  void close(int count, const SurfaceTriangle& triangle, const PlanePressure& pressure, const dvec3& gradient_S,
             double area, const dvec2& centroid, const PolygonSource& source) {
    const ContactPolygon& added = out_.polygons.emplace_back(
        static_cast<int>(used_), count, triangle.push_A, area, triangle.point_A(centroid.x, centroid.y),
        pressure.at(centroid.x, centroid.y), same_frame_ ? gradient_S : X_AS_.R * gradient_S, source.tet, source.tet_b,
        source.face);
    back_faces_.note(inward_ * glm::dot(added.gradient, added.normal), added.gradient);
    used_ += static_cast<std::size_t>(count);
  }
  /// Adds a polygon of a tet alone whose vertices are in slots(). All values are in frame A.
  void close(int count, const dvec3& push_A, double area, const dvec3& centroid_A, double pressure,
             const dvec3& gradient_A, int tet) {
    out_.polygons.emplace_back(static_cast<int>(used_), count, push_A, area, centroid_A, pressure, gradient_A, tet);
    back_faces_.note(inward_ * glm::dot(gradient_A, push_A), gradient_A);
    used_ += static_cast<std::size_t>(count);
  }
  /// Adds a polygon without its vertices that are nearer than the merging distance to the previous vertex, unless too
  /// few would be left.
  void add_merged(const PolygonInPlane& polygon, const SurfaceTriangle& triangle, const PlanePressure& pressure,
                  const dvec3& gradient_S, double area, const dvec2& centroid, const PolygonSource& source);
  /// Adds a polygon outside of all tets, counter-clockwise in the coordinates of the triangle. `size` is the scale of
  /// tolerances [m].
  void add_flat(const FlatPolygon& polygon, const SurfaceTriangle& triangle, const PlanePressure& pressure,
                const dvec3& gradient_S, int face, double size);
  /// Leaves a polygon out of the surface, and counts its area [m^2] and force [N].
  void reject(Rejection reason, const PolygonInPlane& polygon, const SurfaceTriangle& triangle,
              const PlanePressure& pressure, double area);
  /// Returns the record of back faces, which close() adds to.
  [[nodiscard]] BackFaces& back_faces() { return back_faces_; }
  /// Records that a polygon ends on a pad's rigid core along its edge from a to b, in the order of the polygon.
  void count_at_core(const SurfaceTriangle& triangle, const dvec2& a, const dvec2& b, const PlanePressure& pressure);
  /// Releases unused memory and records the area that the cores hide. Call it once, at the end.
  void finish();

  [[nodiscard]] std::size_t polygon_count() const { return out_.polygons.size(); }
  /// Returns the number of polygons so far that end on a pad's core, as recorded by count_at_core().
  [[nodiscard]] int core_count() const {
    constexpr auto kCore = static_cast<std::size_t>(Rejection::beyond_core);
    return whole_.rejected[kCore].count + since_mark_.rejected[kCore].count;
  }
  /// Makes the writer append the middles of all edges that end on a core to `points`, frame A.
  void list_core_points(std::vector<dvec3>& points) {
    points.clear();
    core_points_ = &points;
  }
  /// Discards the record of polygons that end on cores, because depth pieces fill the rest.
  void clear_core();
  /// Returns the present surface. Its arrays have room for more vertices.
  [[nodiscard]] const ContactSurface& surface() const { return out_; }

  /// A state of the writer, to remove all later polygons. Only the last mark can be restored.
  struct Mark {
    std::size_t vertices = 0, polygons = 0, filtered_vertices = 0, filtered = 0, core_points = 0;
  };
  [[nodiscard]] Mark mark() {
    if (any_left_out_) settle();
    return {used_, out_.polygons.size(), out_.filtered_vertices.size(), out_.filtered.size(),
            core_points_ != nullptr ? core_points_->size() : 0};
  }
  void forget_since(const Mark& mark);
  /// Returns the area of the polygons since a mark, including those that were left out [m^2].
  [[nodiscard]] double area_since(const Mark& mark) const;

 private:
  static constexpr std::size_t kSlots = 8;
  /// Parts that are left out of the surface.
  struct LeftOut {
    std::array<RejectedPolygons, kRejections> rejected;
    dvec3 hole{0};            ///< vector area of the edges on cores: half the sum of x cross dx [m^2] (Stokes)
    double rim_length = 0;    ///< [m]
    double rim_pressure = 0;  ///< integral of p along the rim [Pa m]
  };
  void make_room();
  /// Adds the parts left out since the last mark to the total.
  void settle();

  ContactSurface& out_;
  std::size_t used_ = 0;  ///< vertices; out_ has room for more until finish()
  RigidTransform X_AS_;
  bool same_frame_, reverse_;
  double inward_;  ///< 1 if the normal leads into the body that gives gradients, or -1
  BackFaces back_faces_;
  LeftOut whole_, since_mark_;
  bool any_left_out_ = false;  ///< since the last mark
  std::vector<dvec3>* core_points_ = nullptr;
};

inline SurfaceTriangle SurfaceWriter::triangle(const std::array<dvec3, 3>& x_S, const dvec3& normal_S) const {
  SurfaceTriangle t;
  t.x_S = x_S;
  const dvec3 u = x_S[1] - x_S[0], v = x_S[2] - x_S[0];
  t.origin_A = x_S[0];
  t.u_A = u;
  t.v_A = v;
  t.push_A = reverse_ ? -normal_S : normal_S;
  if (!same_frame_) {
    t.origin_A = X_AS_(t.origin_A);
    t.u_A = X_AS_.R * u;
    t.v_A = X_AS_.R * v;
    t.push_A = X_AS_.R * t.push_A;
  }
  t.area = 0.5 * glm::dot(glm::cross(u, v), normal_S);
  t.metric = {glm::dot(u, u), glm::dot(u, v), glm::dot(v, v)};
  return t;
}

}  // namespace taxel
