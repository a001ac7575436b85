// A contact polygon made ready for rays: its plane, and one plane through each edge.
//
// A ray meets the polygon where it meets its plane, at y relative to the centroid, if m y + c >= 0 for every edge. Both
// ray paths compute that in this order of operations, so that they get the same bits.
#pragma once

#include <optional>

#include "core/hydro/contact_surface.h"

namespace taxel {

/// Part of the coordinates by which a polygon may reach over its rim at most. Neighbours are cut one by one, so that
/// their common edge differs by rounding: with this no ray slips through between them. It is a million times what
/// rounding makes and far below what is measured; each ray keeps one hit only, so nothing counts twice.
inline constexpr double kRimReach = 1e-9;

/// Through the edge from corner k to k + 1, at right angles to the polygon: inside where dot(m, y) + c >= 0.
struct EdgePlane {
  dvec3 m{0};    ///< normal cross edge [m]
  double c = 0;  ///< [m^2]
};

/// How far rays that meet the polygon may lie outside of it, at most [m].
inline double rim_reach(double l1_of_centroid, double perimeter) {
  return kRimReach * (l1_of_centroid + perimeter);
}

/// The same of one polygon, its perimeter being at most its number of edges times the longest one [m].
inline double polygon_reach(const ContactPolygon& polygon, double longest_edge) {
  const dvec3& c = polygon.centroid;
  return rim_reach(std::abs(c.x) + std::abs(c.y) + std::abs(c.z), polygon.count * longest_edge);
}

/// Moving every edge of a convex polygon outward by s enlarges it about its inscribed circle at most by 1 + s/r,
/// r >= area/perimeter: so s = reach 2 area / perimeter^2 keeps even a needle's tips within reach. For the perimeter
/// stands what is not less: the number of edges times the longest one, by the sum of its components [m].
inline double edge_shift(const ContactPolygon& polygon, double longest_edge) {
  const double perimeter = polygon.count * longest_edge, reach = polygon_reach(polygon, longest_edge);
  return perimeter > 0 ? reach * 2.0 * polygon.area / (perimeter * perimeter) : 0.0;
}

/// Fills one plane per corner.
inline void fill_edge_planes(const ContactSurface& surface, const ContactPolygon& polygon, EdgePlane* planes) {
  const dvec3* corner = surface.vertices.data() + polygon.first;
  const int last = polygon.count - 1;
  double longest = 0;
  for (int k = 0; k <= last; ++k) {
    const dvec3 edge = glm::abs(corner[k < last ? k + 1 : 0] - corner[k]);
    longest = std::max(longest, edge.x + edge.y + edge.z);
  }
  const double s = edge_shift(polygon, longest);
  for (int k = 0; k <= last; ++k) {
    const dvec3 edge = corner[k < last ? k + 1 : 0] - corner[k];
    const dvec3 m = glm::cross(polygon.normal, edge);
    const double length = std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)});  // not more than it is
    planes[k] = {m, glm::dot(m, polygon.centroid - corner[k]) + s * length};
  }
}

/// Where a ray meets a polygon's plane.
struct PlaneHit {
  double t = 0;            ///< distance along the ray [m]
  dvec3 from_centroid{0};  ///< y [m]
};

/// From either side, with t_min <= t <= t_max; a ray in the plane misses.
inline std::optional<PlaneHit> hit_plane(const dvec3& origin, const dvec3& direction, double t_min, double t_max,
                                         const ContactPolygon& polygon) {
  const dvec3 w = origin - polygon.centroid;
  const double t = -glm::dot(polygon.normal, w) / glm::dot(polygon.normal, direction);
  if (!(t >= t_min && t <= t_max)) return std::nullopt;
  return PlaneHit{t, w + t * direction};
}

/// p0 there [Pa].
inline double pressure_at(const ContactPolygon& polygon, const dvec3& from_centroid) {
  return std::max(0.0, polygon.pressure + glm::dot(polygon.gradient, from_centroid));
}

struct PolygonHit {
  double t = 0;         ///< distance along the ray [m]
  double pressure = 0;  ///< [Pa]
};

/// Where the ray meets the polygon, rim included, likewise.
inline std::optional<PolygonHit> hit_polygon(const dvec3& origin, const dvec3& direction, double t_min, double t_max,
                                             const ContactPolygon& polygon, const EdgePlane* planes) {
  const auto hit = hit_plane(origin, direction, t_min, t_max, polygon);
  if (!hit) return std::nullopt;
  for (int k = 0; k < polygon.count; ++k)
    if (!(glm::dot(planes[k].m, hit->from_centroid) + planes[k].c >= 0)) return std::nullopt;
  return PolygonHit{hit->t, pressure_at(polygon, hit->from_centroid)};
}

}  // namespace taxel
