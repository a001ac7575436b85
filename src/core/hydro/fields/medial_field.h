// Pressure fields of MuJoCo's primitives: p = E depth/H, with H the depth of the medial axis where p = E.
#pragma once

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

// All functions throw Error if a size, the modulus or the edge length is not positive. Round ones are tessellated with
// edges of at most edge_length, and scaled to the true volume.

/// H = smallest half size. Exact.
PressureFieldPtr make_box_field(const dvec3& half_size, double modulus);
/// H = radius; the axis is a segment of z.
PressureFieldPtr make_capsule_field(double radius, double half_length, double modulus, double edge_length);
/// H = min(radius, half_length); the axis is a segment of z, or of a flat cylinder, radius > half_length, a disc.
PressureFieldPtr make_cylinder_field(double radius, double half_length, double modulus, double edge_length);
/// p = E (1 - |x/semi-axes|): not the depth, but linear from the skin to the centre.
PressureFieldPtr make_ellipsoid_field(const dvec3& semi_axes, double modulus, double edge_length);

}  // namespace taxel
