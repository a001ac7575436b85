// Polygons in the coordinates of a triangle become polygons of a contact surface, or are left out and counted.
//
// Vertices nearer than kMergeDistance of the tet's size are merged, since clipping makes several at one corner; area,
// centroid and pressure are those from before. Slivers and polygons without pressure are rejected, with their area and
// force.
//
// A field that ends at a core has a hole in its surface, which is not known. But the hole's rim is: the edges of
// polygons on faces of the core. By Stokes' theorem the area vector of the hole is half of the sum of x_a x x_b along
// the rim, whatever surface fills it, so its area and, with the mean pressure of the rim, its least force are known
// without tets there.
//
// Pitfall: a facet may be written, found incomplete, and written again. So sums are kept since a mark, and are added to
// those of the surface only when the writer goes on (settle()).
#include "core/hydro/kernel/surface_writer.h"

#include <algorithm>

namespace taxel {

SurfaceWriter::SurfaceWriter(ContactSurface& out, const RigidTransform& X_AS, bool reverse, BodyOfPair field)
    : out_(out),
      X_AS_(X_AS),
      same_frame_(X_AS.R == dmat3(1) && X_AS.p == dvec3(0)),
      reverse_(reverse),
      inward_(field == BodyOfPair::a ? 1 : -1) {
  out_.clear();
}

void SurfaceWriter::make_room() {
  const std::size_t room = std::max(out_.vertices.capacity(), 2 * used_ + 64 * kSlots);
  out_.vertices.resize(room);
  out_.pressure.resize(room);
}

void SurfaceWriter::add_merged(const PolygonInPlane& polygon, const SurfaceTriangle& triangle,
                               const PlanePressure& pressure, const dvec3& gradient_S, double area,
                               const dvec2& centroid, const PolygonSource& source) {
  std::array<double, 16> u, v;
  const double limit = kMergeDistance * source.size;
  const auto near = [&](double du, double dv) {
    const PlaneMetric& m = triangle.metric;
    return m.uu * du * du + 2 * m.uv * du * dv + m.vv * dv * dv < limit * limit;
  };
  std::size_t count = 0;
  for (int i = 0; i < polygon.count; ++i) {
    if (count > 0 && near(polygon.u[i] - u[count - 1], polygon.v[i] - v[count - 1])) continue;
    u[count] = polygon.u[i];
    v[count++] = polygon.v[i];
  }
  while (count > 1 && near(u[count - 1] - u[0], v[count - 1] - v[0])) --count;
  // A strip narrower than the merging distance keeps the vertices that span its area.
  const PolygonInPlane merged{u.data(), v.data(), static_cast<int>(count)};
  const PolygonInPlane& kept = count < 3 ? polygon : merged;
  const Slots to = slots();
  for (int i = 0; i < kept.count; ++i) {
    const int k = reverse_ ? kept.count - 1 - i : i;
    to.vertices[i] = triangle.point_A(kept.u[k], kept.v[k]);
    to.pressure[i] = std::max(0.0, pressure.at(kept.u[k], kept.v[k]));
  }
  close(kept.count, triangle, pressure, gradient_S, area, centroid, source);
}

void SurfaceWriter::add_flat(const FlatPolygon& polygon, const SurfaceTriangle& triangle, const PlanePressure& pressure,
                             const dvec3& gradient_S, int face, double size) {
  std::array<double, FlatPolygon::kMaxStored> u{}, v{};
  double twice = 0;
  dvec2 moment(0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(polygon.count); ++k) {
    u[k] = polygon.x[k].x;
    v[k] = polygon.x[k].y;
    if (k < 2) continue;
    const dvec2 a = polygon.x[k - 1] - polygon.x[0], b = polygon.x[k] - polygon.x[0];
    const double part = a.x * b.y - a.y * b.x;
    twice += part;
    moment += part * (a + b);
  }
  const dvec2 centroid = polygon.x[0] + moment / (3 * twice);
  if (!(pressure.at(centroid.x, centroid.y) > 0)) return;
  add_merged({u.data(), v.data(), polygon.count}, triangle, pressure, gradient_S, triangle.area * twice, centroid,
             {-1, face, size});
}

void SurfaceWriter::reject(Rejection reason, const PolygonInPlane& polygon, const SurfaceTriangle& triangle,
                           const PlanePressure& pressure, double area) {
  RejectedPolygons& rejected = since_mark_.rejected[static_cast<std::size_t>(reason)];
  any_left_out_ = true;
  ++rejected.count;
  out_.filtered.push_back({reason, static_cast<int>(out_.filtered_vertices.size()), polygon.count});
  double sum = 0;
  for (int i = 0; i < polygon.count; ++i) {
    sum += pressure.at(polygon.u[i], polygon.v[i]);
    out_.filtered_vertices.push_back(triangle.point_A(polygon.u[i], polygon.v[i]));
  }
  rejected.area += std::max(0.0, area);
  // The mean over the vertices: it has no digits to lose where the polygon is hardly one.
  rejected.force += std::max(0.0, sum / polygon.count * area);
}

void SurfaceWriter::count_at_core(const SurfaceTriangle& triangle, const dvec2& a, const dvec2& b,
                                  const PlanePressure& pressure) {
  any_left_out_ = true;
  ++since_mark_.rejected[static_cast<std::size_t>(Rejection::beyond_core)].count;
  const dvec3 xa = triangle.point_A(a.x, a.y), xb = triangle.point_A(b.x, b.y);
  if (core_points_ != nullptr) core_points_->push_back(0.5 * (xa + xb));
  // The hole lies beyond the edge, so its rim runs the other way. About the frame's origin: the loops are closed.
  since_mark_.hole += 0.5 * glm::cross(xb, xa);
  const double length = glm::distance(xa, xb);
  since_mark_.rim_length += length;
  since_mark_.rim_pressure += 0.5 * length * (pressure.at(a.x, a.y) + pressure.at(b.x, b.y));
}

void SurfaceWriter::settle() {
  for (std::size_t r = 0; r < kRejections; ++r) {
    whole_.rejected[r].count += since_mark_.rejected[r].count;
    whole_.rejected[r].area += since_mark_.rejected[r].area;
    whole_.rejected[r].force += since_mark_.rejected[r].force;
  }
  whole_.hole += since_mark_.hole;
  whole_.rim_length += since_mark_.rim_length;
  whole_.rim_pressure += since_mark_.rim_pressure;
  since_mark_ = {};
  any_left_out_ = false;
}

void SurfaceWriter::finish() {
  out_.vertices.resize(used_);
  out_.pressure.resize(used_);
  settle();
  out_.rejected = whole_.rejected;
  RejectedPolygons& core = out_.rejected[static_cast<std::size_t>(Rejection::beyond_core)];
  if (core.count == 0) return;
  core.area = glm::length(whole_.hole);
  core.force = whole_.rim_length > 0 ? core.area * whole_.rim_pressure / whole_.rim_length : 0.0;
}

void SurfaceWriter::clear_core() {
  settle();
  whole_.rejected[static_cast<std::size_t>(Rejection::beyond_core)] = {};
  whole_.hole = dvec3(0);
  whole_.rim_length = whole_.rim_pressure = 0;
}

void SurfaceWriter::forget_since(const Mark& mark) {
  used_ = mark.vertices;
  out_.polygons.resize(mark.polygons);
  out_.filtered_vertices.resize(mark.filtered_vertices);
  out_.filtered.resize(mark.filtered);
  if (core_points_ != nullptr) core_points_->resize(mark.core_points);
  since_mark_ = {};
  any_left_out_ = false;
}

double SurfaceWriter::area_since(const Mark& mark) const {
  double area = 0;
  for (std::size_t i = mark.polygons; i < out_.polygons.size(); ++i) area += out_.polygons[i].area;
  if (!any_left_out_) return area;
  for (const Rejection reason : {Rejection::sliver, Rejection::touching})
    area += since_mark_.rejected[static_cast<std::size_t>(reason)].area;
  return area;
}

}  // namespace taxel
