// The body of a probe shape, and the checks that all shapes share.
#pragma once

#include "core/base/text/field_spec.h"
#include "core/hydro/hydro_body.h"

namespace taxel {

/// The body of a probe in its own frame, and its tip there.
struct ProbeForm {
  Shape shape;
  dvec3 tip{0};
};

/// Returns a mesh as a shape.
Shape mesh_shape(TriMeshPtr mesh);

/// Throws Error("", "probe", message).
[[noreturn]] void refuse_probe(const std::string& message);

/// Throws Error if the value is not greater than 0 and finite.
void check_probe_length(double value, const char* name);

/// Returns the tangent of half of an opening angle. Throws Error unless the angle is between 0 and 180 degrees.
double half_slope(double angle_deg);

}  // namespace taxel
