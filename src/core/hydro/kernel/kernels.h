// The contact kernels behind intersect(), and the moments of the pressure on its surfaces: each dispatches once to the
// best instruction set of the machine.
#pragma once

#include <algorithm>
#include <array>

#include "core/hydro/contact_surface.h"
#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/hydro/kernel/workspace.h"

namespace taxel {

/// Intersects soft tets with the facets of a rigid mesh with pose X_SR in the field's frame S. Writes in frame S. If
/// the field continues beyond its tets, facets that reach there are listed in workspace.depth.
void intersect_facets(const FieldIndex& field, const FacetTree& rigid, const RigidTransform& X_SR,
                      SurfaceWriter& writer, KernelMemory& workspace);

/// Intersects soft tets with the rigid half-space normal . x + offset <= 0, frame S.
void intersect_plane(const FieldIndex& field, const dvec3& normal, double offset, SurfaceWriter& writer,
                     KernelMemory& workspace);

/// Intersects soft tets with a soft half-space: finds the surface on which the field's pressure equals `pressure`,
/// which is zero on the skin of the half-space and grows inward. Frame S. The normals of the writer's triangles lead
/// into the tets.
void intersect_soft_half_space(const FieldIndex& field, const LinearPressure& pressure, SurfaceWriter& writer,
                               KernelMemory& workspace);

/// Intersects the soft half-space z <= 0 of frame S, p = -stiffness z, with the facets of a rigid mesh with pose
/// X_SR.
void intersect_half_space(double stiffness, const FacetTree& rigid, const RigidTransform& X_SR, SurfaceWriter& writer,
                          KernelMemory& workspace);

/// Intersects soft tets of A with soft tets of B, pose X_AB: finds the surface on which their pressures are equal.
/// Writes in the frame of A, with the pressure of A's tets; the normals of the triangles lead into B.
void intersect_tets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB, SurfaceWriter& writer,
                    KernelMemory& workspace);

/// First moments of the pressure on eight polygons.
using EightMoments = std::array<dvec3, 8>;

/// Integral of p0 x dA over each of the polygons from `first` on, as many as there are and no more than eight, exact
/// for linear p0 [N m]. Needs first < polygons.size().
void find_pressure_moments(const ContactSurface& surface, std::size_t first, EightMoments& moments);

/// Calls f(polygon, its moment) for all polygons, in their order.
template <class F>
void for_each_pressure_moment(const ContactSurface& surface, F&& f) {
  EightMoments moments;
  const std::size_t size = surface.polygons.size();
  for (std::size_t first = 0; first < size; first += moments.size()) {
    find_pressure_moments(surface, first, moments);
    const std::size_t used = std::min(moments.size(), size - first);
    for (std::size_t i = 0; i < used; ++i) f(surface.polygons[first + i], moments[i]);
  }
}

}  // namespace taxel
