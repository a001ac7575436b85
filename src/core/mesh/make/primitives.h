// Meshes made from formulas: MuJoCo's primitive shapes, and the project's own fingertip.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

TriMesh make_box(const dvec3& half_size);                 ///< 12 triangles
TriMesh make_icosphere(double radius, int subdivisions);  ///< 20 * 4^n triangles, vertices on the sphere
TriMesh make_sphere(double radius, double edge_length);   ///< icosphere with edges of at most edge_length
TriMesh make_capsule(double radius, double half_length, double edge_length);   ///< axis z
TriMesh make_cylinder(double radius, double half_length, double edge_length);  ///< axis z, flat caps
TriMesh make_ellipsoid(const dvec3& semi_axes, double edge_length);

// Round shapes for display, with few triangles: long ones along straight sides. Sizes as above, positive.
TriMesh make_drawn_capsule(double radius, double half_length);
TriMesh make_drawn_cylinder(double radius, double half_length);
TriMesh make_drawn_ellipsoid(const dvec3& semi_axes);

/// Returns the mesh scaled about its centroid so that its volume is `volume`.
TriMesh scaled_to_volume(const TriMesh& mesh, double volume);

/// A human-like robot fingertip: metres, pad towards -y, tip towards +z, base in the plane z = 0, mirror symmetric in
/// x; about 18 x 15.5 x 30.5 mm; closed, smooth, about 2000 triangles. Own design from a superellipse section whose
/// half widths shrink smoothly to the tip.
TriMesh make_fingertip();

}  // namespace taxel
