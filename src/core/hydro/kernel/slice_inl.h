// From the slice of a tet to a polygon in plane coordinates. Included once per target.
#if defined(TAXEL_SLICE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_SLICE_INL_H
#undef TAXEL_SLICE_INL_H
#else
#define TAXEL_SLICE_INL_H
#endif

#include "core/hydro/kernel/clip_inl.h"
#include "core/hydro/kernel/slice_tet.h"
#include "core/hydro/kernel/surface_writer.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Corners of the slice that span its coordinates: of a quadrangle the three neighbours with the largest triangle.
HWY_INLINE std::array<int, 3> basis_of(const TetSlice& slice, const dvec3& normal) {
  if (slice.count == 3) return {0, 1, 2};
  int best = 0;
  double most = -1;
  for (int i = 0; i < 4; ++i) {
    const dvec3 &a = slice.points[static_cast<std::size_t>(i)], &b = slice.points[static_cast<std::size_t>((i + 1) % 4)];
    const dvec3& c = slice.points[static_cast<std::size_t>((i + 2) % 4)];
    const double area = glm::dot(glm::cross(b - a, c - a), normal);
    if (area > most) {
      most = area;
      best = i;
    }
  }
  return {best, (best + 1) % 4, (best + 2) % 4};
}

/// The slice as a polygon of its basis triangle, beginning after an edge on one of `core_faces` if there is one, so that
/// this runs from the last vertex to the first. Returns whether there is one; a slice without area has no vertices.
HWY_INLINE bool to_plane(const TetSlice& slice, const std::array<int, 3>& basis, const SurfaceTriangle& triangle,
                         unsigned core_faces, PlanePolygon& polygon) {
  polygon.count = 0;
  const PlaneMetric& m = triangle.metric;
  const double det = m.uu * m.vv - m.uv * m.uv;
  if (!(det > 0)) return false;
  int start = 0;
  bool at_core = false;
  for (int i = 0; i < slice.count; ++i) {
    if ((core_faces & (1u << static_cast<unsigned>(slice.face[static_cast<std::size_t>(i)]))) == 0) continue;
    start = (i + 1) % slice.count;
    at_core = true;
  }
  const dvec3 eu = triangle.x_S[1] - triangle.x_S[0], ev = triangle.x_S[2] - triangle.x_S[0];
  for (int k = 0; k < slice.count; ++k) {
    const int i = (start + k) % slice.count;
    double u = i == basis[1] ? 1 : 0, v = i == basis[2] ? 1 : 0;
    if (i != basis[0] && i != basis[1] && i != basis[2]) {
      const dvec3 r = slice.points[static_cast<std::size_t>(i)] - triangle.x_S[0];
      const double ru = glm::dot(r, eu), rv = glm::dot(r, ev);
      u = (ru * m.vv - rv * m.uv) / det;
      v = (rv * m.uu - ru * m.uv) / det;
    }
    polygon.u[k] = u;
    polygon.v[k] = v;
  }
  polygon.count = slice.count;
  polygon.close();
  return at_core;
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
