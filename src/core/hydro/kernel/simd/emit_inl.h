// Converts a clipped triangle into a polygon of the contact surface, for every instruction set. Included once per
// target.
#if defined(TAXEL_EMIT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_EMIT_INL_H
#undef TAXEL_EMIT_INL_H
#else
#define TAXEL_EMIT_INL_H
#endif

#include "core/hydro/kernel/simd/clip_inl.h"
#include "core/hydro/kernel/surface_writer.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Sums over the triangles of a polygon's fan about its first vertex, in (u, v).
struct FanSums {
  double twice_area, u,
      v;         ///< (u, v): 3 first moments per half unit; centroid = first + sum/(3 area)
  bool crowded;  ///< true if two neighbouring vertices are nearer than the merging distance
};

HWY_INLINE FanSums fan_sums(const PlanePolygon& polygon, const PlaneMetric& metric, double merge_distance) {
  // Lanes beyond the last vertex count with weight 0.
  alignas(64) static constexpr double kCount[16] = {1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  const Eight count = load_eight(kCount + 8 - polygon.count);
  const Lanes& next = kCutLanes.next(polygon.count);
  const Eight u0 = set_eight(first_lane(polygon.u)), v0 = set_eight(first_lane(polygon.v));
  const Eight ua = polygon.u - u0, va = polygon.v - v0, ub = take(ua, next), vb = take(va, next);
  const Eight cross = count * (ua * vb - ub * va);
  const Eight du = ub - ua, dv = vb - va;
  const Eight squared =
      set_eight(metric.uu) * (du * du) + (set_eight(2 * metric.uv) * (du * dv) + set_eight(metric.vv) * (dv * dv));
  const unsigned close = less(squared, set_eight(merge_distance * merge_distance));
  return {sum(cross), sum(cross * (ua + ub)), sum(cross * (va + vb)), (close & ((1u << polygon.count) - 1)) != 0};
}

/// Returns the pressure in the coordinates of the triangle.
HWY_INLINE PlanePressure pressure_on(const SurfaceTriangle& triangle, const LinearPressure& pressure) {
  const dvec3& g = pressure.gradient;
  const double p0 = glm::dot(g, triangle.x_S[0]) + pressure.constant;
  return {p0, glm::dot(g, triangle.x_S[1]) + pressure.constant - p0,
          glm::dot(g, triangle.x_S[2]) + pressure.constant - p0};
}

/// Returns true if a mean pressure is larger than the rounding errors of the pressure in the skin.
HWY_INLINE bool pushes(double mean, const dvec3& gradient, double size) {
  const double least = kTouchingPressure * size;
  return mean > 0 && mean * mean > least * least * glm::dot(gradient, gradient);
}

/// A polygon's vertices in memory.
struct StoredPolygon {
  double u[8], v[8];
  int count;
  explicit HWY_INLINE StoredPolygon(const PlanePolygon& polygon) : count(static_cast<int>(polygon.count)) {
    store_eight(polygon.u, u);
    store_eight(polygon.v, v);
  }
  [[nodiscard]] PolygonInPlane in_plane() const { return {u, v, count}; }
};

/// Returns the component `axis` of origin + u du + v dv.
HWY_INLINE Eight component(const SurfaceTriangle& t, int axis, const Eight& u, const Eight& v) {
  return set_eight(t.origin_A[axis]) + u * set_eight(t.u_A[axis]) + v * set_eight(t.v_A[axis]);
}

/// Adds the polygon to the surface. Writes eight vertices, of which the first `count` are used.
HWY_INLINE void add(const PlanePolygon& polygon, const SurfaceTriangle& triangle, const PlanePressure& p,
                    const dvec3& gradient, double area, const dvec2& centroid, const PolygonSource& source,
                    SurfaceWriter& writer) {
  Eight u = polygon.u, v = polygon.v;
  if (writer.reverse()) {
    const Lanes& backward = kCutLanes.backward(polygon.count);
    u = take(u, backward);
    v = take(v, backward);
  }
  const SurfaceWriter::Slots slots = writer.slots();
  store_interleaved(component(triangle, 0, u, v), component(triangle, 1, u, v), component(triangle, 2, u, v),
                    &slots.vertices->x);
  const Eight pressure = set_eight(p.p0) + u * set_eight(p.pu) + v * set_eight(p.pv);
  store_eight(larger(set_eight(0.0), pressure), slots.pressure);
  writer.close(static_cast<int>(polygon.count), triangle, p, gradient, area, centroid, source);
}

/// Records the edges at which the polygon ends on a pad's core. Bit i of `core_edges` is set if edges with mark i are
/// on the core.
inline HWY_NOINLINE void count_at_core(const PlanePolygon& polygon, unsigned core_edges,
                                       const SurfaceTriangle& triangle, const PlanePressure& p, SurfaceWriter& writer) {
  const StoredPolygon stored(polygon);
  for (int i = 0; i < stored.count; ++i) {
    if ((core_edges >> (polygon.edges >> (8 * i) & 0xff) & 1u) == 0) continue;
    const int next = i + 1 < stored.count ? i + 1 : 0;
    writer.count_at_core(triangle, {stored.u[i], stored.v[i]}, {stored.u[next], stored.v[next]}, p);
  }
}

/// Adds a polygon of `triangle`, or counts the reason why not. Bit i of `core_edges` is set if edges with mark i are on
/// a pad's core.
HWY_INLINE void emit(const PlanePolygon& polygon, unsigned core_edges, const SurfaceTriangle& triangle,
                     const LinearPressure& pressure, const PolygonSource& source, SurfaceWriter& writer) {
  const FanSums sums = fan_sums(polygon, triangle.metric, kMergeDistance * source.size);
  const double area = triangle.area * sums.twice_area;
  if (!(area > kNoArea * source.size * source.size)) return;
  const dvec3& g = pressure.gradient;
  const PlanePressure p = pressure_on(triangle, pressure);
  if (!(area > kSliverArea * source.size * source.size))
    return writer.reject(Rejection::sliver, StoredPolygon(polygon).in_plane(), triangle, p, area);
  const double third = 1.0 / (3.0 * sums.twice_area);
  const dvec2 centroid(first_lane(polygon.u) + sums.u * third, first_lane(polygon.v) + sums.v * third);
  const double p_mean = p.at(centroid.x, centroid.y);
  if (!pushes(p_mean, g, source.size))
    return writer.reject(Rejection::touching, StoredPolygon(polygon).in_plane(), triangle, p, area);
  if (sums.crowded) {
    writer.add_merged(StoredPolygon(polygon).in_plane(), triangle, p, g, area, centroid, source);
  } else {
    add(polygon, triangle, p, g, area, centroid, source, writer);
  }
  if (core_edges != 0) count_at_core(polygon, core_edges, triangle, p, writer);
}

/// Adds the whole facet, `polygon`, which no plane clips.
HWY_INLINE void emit_whole(const PlanePolygon& polygon, const SurfaceTriangle& triangle, const LinearPressure& pressure,
                           const PolygonSource& source, SurfaceWriter& writer) {
  const PlaneMetric& m = triangle.metric;
  const bool is_triangle = polygon.count == 3;
  const double near = kMergeDistance * source.size, middle = is_triangle ? 1.0 / 3.0 : 0.5;
  const double area = is_triangle ? triangle.area : 2 * triangle.area;
  double shortest = std::min(m.uu, m.vv);
  if (is_triangle) shortest = std::min(shortest, m.uu - 2 * m.uv + m.vv);
  const PlanePressure p = pressure_on(triangle, pressure);
  const double p_mean = p.at(middle, middle);
  if (!(shortest > near * near) || !(area > kSliverArea * source.size * source.size) ||
      !pushes(p_mean, pressure.gradient, source.size)) {
    emit(polygon, 0, triangle, pressure, source, writer);
    return;
  }
  add(polygon, triangle, p, pressure.gradient, area, dvec2(middle), source, writer);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
