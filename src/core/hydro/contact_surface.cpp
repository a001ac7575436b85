#include "core/hydro/contact_surface.h"

namespace taxel {

const char* to_string(Rejection reason) {
  switch (reason) {
    case Rejection::sliver:
      return "sliver";
    case Rejection::touching:
      return "touching";
    case Rejection::beyond_core:
      return "beyond_core";
    default:
      return "back_face";
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

void mirror(const ContactSurface& surface, const RigidTransform& X_BA, ContactSurface& out) {
  out.clear();
  out.vertices.resize(surface.vertices.size());
  out.pressure.resize(surface.pressure.size());
  for (ContactPolygon polygon : surface.polygons) {
    const auto first = static_cast<std::size_t>(polygon.first), count = static_cast<std::size_t>(polygon.count);
    for (std::size_t i = 0; i < count; ++i) {  // the first corner stays the first: fans keep their triangles
      const std::size_t from = first + (count - i) % count;
      out.vertices[first + i] = X_BA(surface.vertices[from]);
      out.pressure[first + i] = surface.pressure[from];
    }
    polygon.normal = -(X_BA.R * polygon.normal);
    polygon.centroid = X_BA(polygon.centroid);
    polygon.gradient = X_BA.R * polygon.gradient;
    if (polygon.tet_b >= 0) std::swap(polygon.tet, polygon.tet_b);
    out.polygons.push_back(polygon);
  }
  out.rejected = surface.rejected;
  for (const dvec3& vertex : surface.filtered_vertices) out.filtered_vertices.push_back(X_BA(vertex));
  out.filtered = surface.filtered;
}

}  // namespace taxel
