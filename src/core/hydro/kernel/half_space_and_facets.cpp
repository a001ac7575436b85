// A soft half-space against the facets of a rigid mesh: one cut per facet.
//
// The pressure is linear in the whole half-space z <= 0, and the contact surface is the part of each facet below z = 0.
// The tree gives the facets that may reach below, and each is cut once at the plane. The pressure -stiffness z is exact
// on the polygon, so rounding is the only error of this pair.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/half_space_and_facets.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/simd/emit_inl.h"
#include "core/hydro/kernel/simd/tree_query_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

void run_half_space(double stiffness, const FacetTree& rigid, const RigidTransform& X_SR, SurfaceWriter& writer,
                    KernelMemory& workspace) {
  // In the frame of the tree: up is the half-space's normal.
  const dvec3 up(X_SR.R[0].z, X_SR.R[1].z, X_SR.R[2].z);
  BehindPlane query;
  query.plane.set(up, X_SR(rigid.tree().origin()).z, rigid.tree());
  workspace.facets.clear();
  collect(rigid.tree(), query, workspace.facets);
  const LinearPressure pressure{{0, 0, -stiffness}, 0};
  for (const std::int32_t f : workspace.facets) {
    const FacetTree::Facet& source = rigid.facets()[static_cast<std::size_t>(f)];
    std::array<dvec3, 3> x;
    for (std::size_t c = 0; c < 3; ++c) x[c] = X_SR(rigid.vertices()[static_cast<std::size_t>(source.vertex[c])]);
    const bool is_below = x[0].z < 0 || x[1].z < 0 || x[2].z < 0;
    if (!is_below && !(source.corners == 4 && x[1].z + x[2].z < x[0].z)) continue;
    const SurfaceTriangle triangle = writer.triangle(x, X_SR.R * source.normal);
    PlanePolygon polygon = whole_facet(source.corners);
    if (keep_inside(-x[0].z, -x[1].z, -x[2].z, 0, polygon) == Cut::nothing_inside) continue;
    const PolygonSource from{-1, source.face, std::sqrt(2.0 * triangle.area)};
    emit(polygon, 0, triangle, pressure, from, writer);
  }
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_half_space);

void intersect_half_space(double stiffness, const FacetTree& rigid, const RigidTransform& X_SR, SurfaceWriter& writer,
                          KernelMemory& workspace) {
  HWY_DYNAMIC_DISPATCH(run_half_space)(stiffness, rigid, X_SR, writer, workspace);
}
}  // namespace taxel
#endif
