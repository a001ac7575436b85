// First moments of the pressure, eight polygons at a time.
#pragma once

#include <vector>

#include "core/hydro/contact_surface.h"

namespace taxel {

/// Integral of p0 x dA over each polygon of the surface, exact for linear p0 [N m]. Keeps the memory of `moments`.
void find_pressure_moments(const ContactSurface& surface, std::vector<dvec3>& moments);

}  // namespace taxel
