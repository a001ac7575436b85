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
    const dvec3 &a = slice.points[static_cast<std::size_t>(i)],
                &b = slice.points[static_cast<std::size_t>((i + 1) % 4)];
    const dvec3& c = slice.points[static_cast<std::size_t>((i + 2) % 4)];
    const double area = glm::dot(glm::cross(b - a, c - a), normal);
    if (area > most) {
      most = area;
      best = i;
    }
  }
  return {best, (best + 1) % 4, (best + 2) % 4};
}

/// The slice as a polygon of its basis triangle x, its edges marked kOwnEdge + the sliced tet's face; without vertices
/// where it has no area.
HWY_INLINE void to_plane(const TetSlice& slice, const std::array<int, 3>& basis, const std::array<dvec3, 3>& x,
                         PlanePolygon& polygon) {
  polygon.count = 0;
  polygon.edges = 0;
  double at_u[8] = {}, at_v[8] = {};
  const dvec3 eu = x[1] - x[0], ev = x[2] - x[0];
  const PlaneMetric m{glm::dot(eu, eu), glm::dot(eu, ev), glm::dot(ev, ev)};
  const double det = m.uu * m.vv - m.uv * m.uv;
  if (!(det > 0)) return;
  for (int i = 0; i < slice.count; ++i) {
    double u = i == basis[1] ? 1 : 0, v = i == basis[2] ? 1 : 0;
    if (i != basis[0] && i != basis[1] && i != basis[2]) {
      const dvec3 r = slice.points[static_cast<std::size_t>(i)] - x[0];
      const double ru = glm::dot(r, eu), rv = glm::dot(r, ev);
      u = (ru * m.vv - rv * m.uv) / det;
      v = (rv * m.uu - ru * m.uv) / det;
    }
    at_u[i] = u;
    at_v[i] = v;
    polygon.edges |= (kOwnEdge + static_cast<std::uint64_t>(slice.face[static_cast<std::size_t>(i)])) << (8 * i);
  }
  polygon.u = load_eight(at_u);
  polygon.v = load_eight(at_v);
  polygon.count = static_cast<unsigned>(slice.count);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
