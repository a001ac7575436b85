// Soft tets against a rigid or a soft half-space: one slice per tet.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hydro/kernel/tets_and_half_spaces.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/simd/emit_inl.h"
#include "core/hydro/kernel/simd/slice_inl.h"
#include "core/hydro/kernel/simd/tree_query_inl.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// Adds the slice of tet `index` where `distances` of its corners are 0; `normal` is that of growing distance.
HWY_INLINE void add_slice(const FieldIndex& field, std::int32_t index, const std::array<dvec3, 4>& corners,
                          const std::array<double, 4>& distances, const dvec3& normal, SurfaceWriter& writer) {
  const PackedTet& tet = field.tets()[static_cast<std::size_t>(index)];
  TetSlice slice;
  slice_tet(corners, field.vertices_of(index), distances, slice);
  if (slice.count == 0) return;
  const std::array<int, 3> basis = basis_of(slice, normal);
  const SurfaceTriangle triangle = writer.triangle(
      {slice.points[static_cast<std::size_t>(basis[0])], slice.points[static_cast<std::size_t>(basis[1])],
       slice.points[static_cast<std::size_t>(basis[2])]},
      normal);
  SliceInPlane in_plane;
  if (!to_plane(slice, basis, triangle.x_S, normal, in_plane)) return;
  emit(in_plane.polygon, tet.core_faces << kOwnEdge, triangle, tet.pressure(), {index, -1, tet.size}, writer);
}

void run_plane(const FieldIndex& field, const dvec3& normal, double offset, SurfaceWriter& writer,
               IntersectWorkspace& workspace) {
  ThroughPlane query;
  query.plane.set(normal, glm::dot(normal, field.tree().origin()) + offset, field.tree());
  workspace.tets.clear();
  collect(field.tree(), query, workspace.tets);
  for (const std::int32_t index : workspace.tets) {
    const std::array<dvec3, 4> corners = field.corners(index);
    std::array<double, 4> distances;
    for (std::size_t i = 0; i < 4; ++i) distances[i] = glm::dot(normal, corners[i]) + offset;
    add_slice(field, index, corners, distances, normal, writer);
  }
}

void run_soft_half_space(const FieldIndex& field, const LinearPressure& pressure, SurfaceWriter& writer,
                         IntersectWorkspace& workspace) {
  const double stiffness = glm::length(pressure.gradient);
  const dvec3 inward = pressure.gradient / stiffness;
  BehindPlane query;
  query.plane.set(-inward, -(glm::dot(inward, field.tree().origin()) + pressure.constant / stiffness), field.tree());
  workspace.tets.clear();
  collect(field.tree(), query, workspace.tets);
  for (const std::int32_t index : workspace.tets) {
    const PackedTet& tet = field.tets()[static_cast<std::size_t>(index)];
    const std::array<dvec3, 4> corners = field.corners(index);
    const std::array<double, 4> own = field.corner_pressures(index);
    const dvec3 difference = tet.pressure().gradient - pressure.gradient;
    const double steepness = glm::length(difference);
    if (!(steepness > 0)) continue;
    std::array<double, 4> distances;  // (p - p of the half-space)/|gradient|: in metres from the plane where they agree
    for (std::size_t i = 0; i < 4; ++i)
      distances[i] = (own[i] - (glm::dot(pressure.gradient, corners[i]) + pressure.constant)) / steepness;
    add_slice(field, index, corners, distances, difference / steepness, writer);
  }
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_plane);
HWY_EXPORT(run_soft_half_space);

void intersect_plane(const FieldIndex& field, const dvec3& normal, double offset, SurfaceWriter& writer,
                     IntersectWorkspace& workspace) {
  HWY_DYNAMIC_DISPATCH(run_plane)(field, normal, offset, writer, workspace);
}
void intersect_soft_half_space(const FieldIndex& field, const LinearPressure& pressure, SurfaceWriter& writer,
                               IntersectWorkspace& workspace) {
  HWY_DYNAMIC_DISPATCH(run_soft_half_space)(field, pressure, writer, workspace);
}
}  // namespace taxel
#endif
