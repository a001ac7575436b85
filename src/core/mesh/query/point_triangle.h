// The point of one triangle that is nearest to a query point.
#pragma once

#include <tuple>

#include "core/base/math.h"

namespace taxel {

struct TrianglePoint {
  dvec3 position{0};
  dvec3 barycentric{0};         ///< weights of a, b, c; exactly 0 for corners off the nearest edge or vertex
  double squared_distance = 0;  ///< squared distance from the query [m^2]
};

/// Finds the nearest point of the segment a b. The result has the same bits for both orders of the ends, so that two
/// triangles agree at their shared edge.
inline double nearest_on_segment(const dvec3& p, const dvec3& a, const dvec3& b, dvec3& nearest) {
  const bool swapped = std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z);
  const dvec3& from = swapped ? b : a;
  const dvec3& to = swapped ? a : b;
  const dvec3 edge = to - from;
  const double t = glm::dot(p - from, edge) / glm::dot(edge, edge);
  if (!(t > 0)) {
    nearest = from;
    return swapped ? 1.0 : 0.0;
  }
  if (t >= 1) {
    nearest = to;
    return swapped ? 0.0 : 1.0;
  }
  nearest = from + t * edge;
  return swapped ? 1.0 - t : t;
}

/// Returns the foot of the perpendicular if it is inside the triangle. Otherwise returns the nearest point of the edges
/// that have the foot on their outer side to within rounding, which is stable on slivers too.
inline TrianglePoint nearest_on_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 normal = glm::cross(b - a, c - a);
  const dvec3 pa = a - p, pb = b - p, pc = c - p;
  const double u = glm::dot(normal, glm::cross(pb, pc));
  const double v = glm::dot(normal, glm::cross(pc, pa));
  const double w = glm::dot(normal, glm::cross(pa, pb));
  TrianglePoint best;
  if (u > 0 && v > 0 && w > 0) {
    best.barycentric = dvec3(u, v, w) / (u + v + w);
    best.position = p - normal * (glm::dot(p - a, normal) / glm::dot(normal, normal));
    best.squared_distance = glm::dot(p - best.position, p - best.position);
    return best;
  }
  best.squared_distance = std::numeric_limits<double>::infinity();
  const dvec3* corner[3] = {&a, &b, &c};
  const double opposite[3] = {w, u, v};
  // The largest rounding error of the cross products above and of the normal.
  const double error = 64 * std::numeric_limits<double>::epsilon() * (glm::dot(b - a, b - a) + glm::dot(c - a, c - a)) *
                       (glm::dot(pa, pa) + glm::dot(pb, pb) + glm::dot(pc, pc));
  for (int e = 0; e < 3; ++e) {
    if (opposite[e] > error) continue;
    dvec3 q;
    const double t = nearest_on_segment(p, *corner[e], *corner[(e + 1) % 3], q);
    const double d2 = glm::dot(p - q, p - q);
    if (d2 >= best.squared_distance) continue;
    best.squared_distance = d2;
    best.position = q;
    best.barycentric = dvec3(0);
    best.barycentric[e] = 1.0 - t;
    best.barycentric[(e + 1) % 3] = t;
  }
  return best;
}

}  // namespace taxel
