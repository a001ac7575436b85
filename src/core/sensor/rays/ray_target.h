// A contact polygon prepared for rays: its plane, one plane through each edge, and its place in a view of rays.
//
// A ray hits the polygon if m y + c >= 0 for every edge, y being the point on the polygon's plane relative to its
// centroid. All ray paths compute this in the same order of operations, so that they get the same bits.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/hydro/contact_surface.h"

namespace taxel {

/// Largest distance by which a polygon is enlarged beyond its rim, as a fraction of the coordinates. Neighbours are
/// computed separately, and their common edge differs by rounding: without the enlargement a ray could pass between
/// them. The fraction is a million times the rounding and far below measurable lengths. Each ray keeps one hit, so no
/// pressure counts twice.
inline constexpr double kRimReach = 1e-9;

/// The plane through the edge from corner k to k + 1, perpendicular to the polygon. Inside is dot(m, y) + c >= 0.
struct EdgePlane {
  dvec3 m{0};    ///< normal cross edge [m]
  double c = 0;  ///< offset [m^2]
};

/// Returns the largest distance outside of a polygon at which a ray may hit it [m].
inline double rim_reach(double l1_of_centroid, double perimeter) {
  return kRimReach * (l1_of_centroid + perimeter);
}

/// Returns rim_reach() of a polygon, whose perimeter is at most its number of edges times the longest edge [m].
inline double polygon_reach(const ContactPolygon& polygon, double longest_edge) {
  const dvec3& c = polygon.centroid;
  return rim_reach(std::abs(c.x) + std::abs(c.y) + std::abs(c.z), polygon.count * longest_edge);
}

/// Returns the outward shift of the edges [m]. A shift s of every edge of a convex polygon enlarges it about its
/// inscribed circle by at most 1 + s/r, r >= area/perimeter. So s = reach 2 area / perimeter^2 keeps even the tips of a
/// needle within reach. The perimeter is estimated from above: the number of edges times the longest, by the sum of its
/// components.
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
    const double length = std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)});  // at most the length
    planes[k] = {m, glm::dot(m, polygon.centroid - corner[k]) + s * length};
  }
}

/// The intersection of a ray and a polygon's plane.
struct PlaneHit {
  double t = 0;            ///< distance along the ray [m]
  dvec3 from_centroid{0};  ///< point relative to the centroid, y above [m]
};

/// Returns the intersection with the plane from either side, if t_min <= t <= t_max. A ray in the plane misses.
inline std::optional<PlaneHit> hit_plane(const dvec3& origin, const dvec3& direction, double t_min, double t_max,
                                         const ContactPolygon& polygon) {
  const dvec3 w = origin - polygon.centroid;
  const double t = -glm::dot(polygon.normal, w) / glm::dot(polygon.normal, direction);
  if (!(t >= t_min && t <= t_max)) return std::nullopt;
  return PlaneHit{t, w + t * direction};
}

/// Returns the pressure p0 at a point of the polygon [Pa].
inline double pressure_at(const ContactPolygon& polygon, const dvec3& from_centroid) {
  return std::max(0.0, polygon.pressure + glm::dot(polygon.gradient, from_centroid));
}

/// The hit of a ray on a polygon.
struct PolygonHit {
  double t = 0;         ///< distance along the ray [m]
  double pressure = 0;  ///< pressure p0 at the hit [Pa]
};

/// Returns the hit on the polygon from either side, the rim included, if t_min <= t <= t_max.
inline std::optional<PolygonHit> hit_polygon(const dvec3& origin, const dvec3& direction, double t_min, double t_max,
                                             const ContactPolygon& polygon, const EdgePlane* planes) {
  const auto hit = hit_plane(origin, direction, t_min, t_max, polygon);
  if (!hit) return std::nullopt;
  for (int k = 0; k < polygon.count; ++k)
    if (!(glm::dot(planes[k].m, hit->from_centroid) + planes[k].c >= 0)) return std::nullopt;
  return PolygonHit{hit->t, pressure_at(polygon, hit->from_centroid)};
}

/// A contact polygon in a view (sensor_ray.h), whose rays are nearly parallel to its axis; in single precision.
struct RayTarget {
  static constexpr std::size_t kGroup = 4, kGroups = 2;
  std::array<float, 4> centroid{}, normal{};  ///< depth, u, v
  float slack = 0, tilt = 0;                  ///< error of edge distances: constant, and per 1 / |rise| [m^2]
  /// For a point at u, v from the centroid, du[k] v - dv[k] u + c[k] is the length of edge k times the distance of the
  /// point to the inside of the edge. Places after the last edge repeat other edges.
  struct Edges {
    std::array<float, kGroup> du{}, dv{}, c{};
  };
  std::array<Edges, kGroups> edges{};
};

/// Scratch memory of casting by polygons. It is reused, so that no step allocates after the largest surface.
struct CastBuffers {
  RayTarget target;                         ///< tested polygon
  NumberBuffer<std::int32_t> polygon, ray;  ///< pairs of a polygon and a ray that surely hits it
  std::vector<EdgePlane> planes;            ///< edges of a polygon whose rim is near a ray
  std::vector<dvec3> corners;               ///< corners of the last polygon of a surface, with padding
  std::vector<std::int32_t> groups;         ///< groups of rays near a polygon
};

}  // namespace taxel
