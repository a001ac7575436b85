// One ray against one triangle.
#pragma once

#include <optional>

#include "core/mesh/bvh.h"

namespace taxel {

struct TriangleHit {
  double t = 0;          ///< distance along the ray [m]
  dvec3 barycentric{0};  ///< weights of a, b, c; sum 1, none negative
};

/// The hit of a ray on the triangle a b c from either side, rim included, with 0 <= t <= ray.t_max.
///
/// Moeller and Trumbore's quotients of triple products (1997), written edge by edge: with a', b', c' relative to the
/// origin the weights are u = d.(c' x b'), v = d.(a' x c'), w = d.(b' x a'), over u + v + w = -d.n. The product of an
/// edge seen from its other triangle is the exact negative in floating point too, so a ray through a shared edge cannot
/// slip between the two. No epsilons; a ray in the triangle's plane misses.
inline std::optional<TriangleHit> intersect_triangle(const Ray& ray, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 a0 = a - ray.origin, b0 = b - ray.origin, c0 = c - ray.origin;
  const double u = glm::dot(ray.direction, glm::cross(c0, b0));
  const double v = glm::dot(ray.direction, glm::cross(a0, c0));
  const double w = glm::dot(ray.direction, glm::cross(b0, a0));
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double sum = u + v + w;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double slope = glm::dot(normal, ray.direction);
  if (sum == 0 || slope == 0) return std::nullopt;
  const double t = glm::dot(normal, a0) / slope;
  if (!(t >= 0 && t <= ray.t_max)) return std::nullopt;
  return TriangleHit{t, dvec3(u, v, w) / sum};
}

}  // namespace taxel
