// First moments of the pressure, eight polygons at a time.
#pragma once

#include <algorithm>
#include <array>

#include "core/hydro/contact_surface.h"

namespace taxel {

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
