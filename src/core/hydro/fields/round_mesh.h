// Tessellated round shapes with the exact volume of their shape: force is proportional to volume wherever the pressure
// is linear, so the facets cause no first-order error.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace taxel {

// Axis z, edges of about edge_length at most. Radii grow a little; the lengths of cylinders, and of the axes of
// capsules, stay exact. Throw Error when a size or the edge length is not positive.

TriMesh make_round_sphere(double radius, double edge_length);
TriMesh make_round_capsule(double radius, double half_length, double edge_length);
TriMesh make_round_cylinder(double radius, double half_length, double edge_length);
/// The same shape with a ring of vertices at radius - half_length on each cap, where the depth's medial axis ends if it
/// is a disc (radius > half_length), and with vertices at the same angles on all rings outside of it.
TriMesh make_round_flat_cylinder(double radius, double half_length, double edge_length);
TriMesh make_round_ellipsoid(const dvec3& semi_axes, double edge_length);

}  // namespace taxel
