// From a clipped triangle to a polygon of the contact surface, for every instruction set. Included once per target.
#if defined(TAXEL_EMIT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_EMIT_INL_H
#undef TAXEL_EMIT_INL_H
#else
#define TAXEL_EMIT_INL_H
#endif

#include "core/hydro/kernel/clip_inl.h"
#include "core/hydro/kernel/surface_writer.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Sums over the triangles of a polygon's fan about its first vertex, in (u, v).
struct FanSums {
  double twice_area, u,
      v;         ///< (u, v): three times the first moment over half the unit: centroid = first + sum/(3 area)
  bool crowded;  ///< two neighbouring vertices are nearer than the merging distance
};

HWY_INLINE FanSums fan_sums(const PlanePolygon& polygon, const PlaneMetric& metric, double merge_distance) {
  // Lanes beyond the last vertex hold the second round: they count with weight 0.
  alignas(64) static constexpr double kCount[16] = {1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  const double* count = kCount + 8 - polygon.count;
  const TagD d;
  alignas(64) double cross[8], moment_u[8], moment_v[8];
  const VecD u0 = hn::Set(d, polygon.u[0]), v0 = hn::Set(d, polygon.v[0]);
  const VecD near = hn::Set(d, merge_distance * merge_distance);
  unsigned close = 0;
  for (std::size_t i = 0; i < 8; i += kLanesD) {
    const VecD ua = hn::Sub(hn::Load(d, polygon.u + i), u0), va = hn::Sub(hn::Load(d, polygon.v + i), v0);
    const VecD ub = hn::Sub(hn::LoadU(d, polygon.u + i + 1), u0), vb = hn::Sub(hn::LoadU(d, polygon.v + i + 1), v0);
    const VecD c = hn::Mul(hn::LoadU(d, count + i), hn::Sub(hn::Mul(ua, vb), hn::Mul(ub, va)));
    hn::Store(c, d, cross + i);
    hn::Store(hn::Mul(c, hn::Add(ua, ub)), d, moment_u + i);
    hn::Store(hn::Mul(c, hn::Add(va, vb)), d, moment_v + i);
    const VecD du = hn::Sub(ub, ua), dv = hn::Sub(vb, va);
    const VecD squared = hn::Add(
        hn::Mul(hn::Set(d, metric.uu), hn::Mul(du, du)),
        hn::Add(hn::Mul(hn::Set(d, 2 * metric.uv), hn::Mul(du, dv)), hn::Mul(hn::Set(d, metric.vv), hn::Mul(dv, dv))));
    close |= mask_bits(d, hn::Lt(squared, near)) << i;
  }
  close &= (1u << static_cast<unsigned>(polygon.count)) - 1;
  return {sum_of_eight(cross), sum_of_eight(moment_u), sum_of_eight(moment_v), close != 0};
}

/// The pressure in the coordinates of the triangle.
HWY_INLINE PlanePressure pressure_on(const SurfaceTriangle& triangle, const LinearPressure& pressure) {
  const dvec3& g = pressure.gradient;
  const double p0 = glm::dot(g, triangle.x_S[0]) + pressure.constant;
  return {p0, glm::dot(g, triangle.x_S[1]) + pressure.constant - p0,
          glm::dot(g, triangle.x_S[2]) + pressure.constant - p0};
}

/// Whether a mean pressure stands out of what rounding leaves in the skin.
HWY_INLINE bool pushes(double mean, const dvec3& gradient, double size) {
  const double least = kTouchingPressure * size;
  return mean > 0 && mean * mean > least * least * glm::dot(gradient, gradient);
}

/// Adds a polygon of `triangle`, or counts why not. `core_edges`: bit i, edges marked i lie on a pad's core.
HWY_INLINE void emit(const PlanePolygon& polygon, unsigned core_edges, const SurfaceTriangle& triangle,
                     const LinearPressure& pressure, const PolygonSource& source, SurfaceWriter& writer) {
  const PolygonInPlane in_plane{polygon.u, polygon.v, polygon.count};
  const FanSums sums = fan_sums(polygon, triangle.metric, kMergeDistance * source.size);
  const double area = triangle.area * sums.twice_area;
  if (!(area > kNoArea * source.size * source.size)) return;
  if (!(area > kSliverArea * source.size * source.size))
    return writer.reject(Rejection::sliver, in_plane, triangle, area, 0);
  const dvec3& g = pressure.gradient;
  const PlanePressure p = pressure_on(triangle, pressure);
  const double third = 1.0 / (3.0 * sums.twice_area);
  const dvec2 centroid(polygon.u[0] + sums.u * third, polygon.v[0] + sums.v * third);
  const double p_mean = p.at(centroid.x, centroid.y);
  if (!pushes(p_mean, g, source.size))
    return writer.reject(Rejection::touching, in_plane, triangle, area, p_mean * area);
  if (sums.crowded) {
    writer.add_merged(in_plane, triangle, p, g, area, centroid, source);
  } else {
    writer.add(in_plane, triangle, p, g, area, centroid, source);
  }
  if (core_edges == 0) return;
  for (int i = 0; i < polygon.count; ++i) {
    if ((core_edges >> (polygon.edges >> (8 * i) & 0xff) & 1u) == 0) continue;
    // In the second round the vertex after the last one is the first one.
    writer.count_at_core(triangle, {polygon.u[i], polygon.v[i]}, {polygon.u[i + 1], polygon.v[i + 1]}, p);
  }
}

/// The same for the whole triangle, `polygon`, which no plane cuts.
HWY_INLINE void emit_whole(const PlanePolygon& polygon, const SurfaceTriangle& triangle, const LinearPressure& pressure,
                           const PolygonSource& source, SurfaceWriter& writer) {
  const PlaneMetric& m = triangle.metric;
  const double near = kMergeDistance * source.size, third = 1.0 / 3.0;
  const double shortest = std::min(std::min(m.uu, m.vv), m.uu - 2 * m.uv + m.vv);
  const PlanePressure p = pressure_on(triangle, pressure);
  const double p_mean = p.at(third, third);
  if (!(shortest > near * near) || !(triangle.area > kSliverArea * source.size * source.size) ||
      !pushes(p_mean, pressure.gradient, source.size)) {
    emit(polygon, 0, triangle, pressure, source, writer);
    return;
  }
  writer.add({polygon.u, polygon.v, polygon.count}, triangle, p, pressure.gradient, triangle.area, dvec2(third),
             source);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
