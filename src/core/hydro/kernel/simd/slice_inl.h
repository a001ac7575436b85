// From the slice of a tet to a polygon in plane coordinates. Included once per target.
#if defined(TAXEL_SLICE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_SLICE_INL_H
#undef TAXEL_SLICE_INL_H
#else
#define TAXEL_SLICE_INL_H
#endif

#include "core/hydro/kernel/simd/clip_inl.h"
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

/// A slice in the coordinates of its basis triangle, its edges marked kOwnEdge + the sliced tet's face.
struct SliceInPlane {
  PlanePolygon polygon;
  dvec2 fourth{0};  ///< coordinates of a quadrangle's point that is not of the basis
};

/// False where the slice has no area.
HWY_INLINE bool to_plane(const TetSlice& slice, const std::array<int, 3>& basis, const std::array<dvec3, 3>& x,
                         const dvec3& normal, SliceInPlane& out) {
  out.polygon.edges = 0;
  for (int i = 0; i < slice.count; ++i)
    out.polygon.edges |= (kOwnEdge + static_cast<std::uint64_t>(slice.face[static_cast<std::size_t>(i)])) << (8 * i);
  out.polygon.count = static_cast<unsigned>(slice.count);
  if (slice.count == 3) {
    const PlanePolygon whole = whole_facet(3);
    out.polygon.u = whole.u;
    out.polygon.v = whole.v;
    return true;
  }
  const dvec3 eu = x[1] - x[0], ev = x[2] - x[0];
  // Ratios of areas, which keep their digits in strips: those of squared lengths would lose twice as many.
  const dvec3 beside_v = glm::cross(ev, normal), beside_u = glm::cross(normal, eu);
  const double area = glm::dot(eu, beside_v);
  if (!(area > 0)) return false;
  const auto other = static_cast<std::size_t>((basis[2] + 1) % 4);
  const dvec3 r = slice.points[other] - x[0];
  out.fourth = dvec2(glm::dot(r, beside_v), glm::dot(r, beside_u)) / area;
  double u[8] = {}, v[8] = {};
  u[basis[1]] = 1;
  v[basis[2]] = 1;
  u[other] = out.fourth.x;
  v[other] = out.fourth.y;
  out.polygon.u = load_eight(u);
  out.polygon.v = load_eight(v);
  return true;
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
