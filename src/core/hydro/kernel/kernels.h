// The contact kernels behind intersect(): each dispatches once to the best instruction set of the machine.
#pragma once

#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/hydro/kernel/workspace.h"

namespace taxel {

/// Soft tets against the triangles of a rigid mesh with pose X_SR in the field's frame S. Writes in frame S. Triangles
/// that reach beyond the tets of a field that goes on there are listed in workspace.depth.
void intersect_triangles(const FieldIndex& field, const TriangleTree& rigid, const RigidTransform& X_SR,
                         SurfaceWriter& writer, IntersectWorkspace& workspace);

/// Soft tets against the rigid half-space normal . x + offset <= 0, frame S.
void intersect_plane(const FieldIndex& field, const dvec3& normal, double offset, SurfaceWriter& writer,
                     IntersectWorkspace& workspace);

/// Soft tets against a soft half-space: where the field's pressure equals the half-space's, `pressure`, which is zero
/// on its skin and grows inward. Frame S. The writer's triangles have the normal that leads into the tets.
void intersect_soft_half_space(const FieldIndex& field, const LinearPressure& pressure, SurfaceWriter& writer,
                               IntersectWorkspace& workspace);

/// The soft half-space z <= 0 of frame S, p = -stiffness z, against the triangles of a rigid mesh with pose X_SR.
void intersect_half_space(double stiffness, const TriangleTree& rigid, const RigidTransform& X_SR,
                          SurfaceWriter& writer, IntersectWorkspace& workspace);

/// Soft tets of A against those of B, pose X_AB: where their pressures are equal. Written in the frame of A, with the
/// pressure of A's tets; the triangles' normals lead into B.
void intersect_tets(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB, SurfaceWriter& writer,
                    IntersectWorkspace& workspace);

}  // namespace taxel
