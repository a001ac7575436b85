#include "core/hydro/contact_surface.h"

namespace taxel {

const char* to_string(Rejection reason) {
  switch (reason) {
    case Rejection::sliver:
      return "sliver";
    case Rejection::touching:
      return "touching";
    default:
      return "beyond_core";
  }
}

void ContactSurface::clear() {
  vertices.clear();
  pressure.clear();
  polygons.clear();
  rejected = {};
  filtered_vertices.clear();
  filtered.clear();
}

double ContactSurface::area() const {
  double sum = 0;
  for (const ContactPolygon& polygon : polygons) sum += polygon.area;
  return sum;
}

double ContactSurface::max_pressure() const {
  return pressure.empty() ? 0.0 : *std::max_element(pressure.begin(), pressure.end());
}

int ContactSurface::triangle_count() const {
  int sum = 0;
  for (const ContactPolygon& polygon : polygons) sum += polygon.count - 2;
  return sum;
}

}  // namespace taxel
