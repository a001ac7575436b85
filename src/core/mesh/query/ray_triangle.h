// Watertight intersection of rays with triangles.
#pragma once

#include <optional>

#include "core/mesh/query/bvh.h"

namespace taxel {

struct TriangleHit {
  double t = 0;          ///< distance along the ray [m]
  dvec3 barycentric{0};  ///< weights of a, b, c; sum 1, none negative
};

/// One ray prepared for many triangles.
///
/// Solves Moeller and Trumbore's system (1997) the watertight way of Woop, Benthin and Wald (2013): a shear that
/// depends on the ray alone maps the ray to an axis, so all triangles at a vertex or an edge have the same rounded 2-D
/// points. The weights are 2-D cross products; rounding can make their sign zero but never wrong, and zero is inside.
/// So no ray passes between triangles at a shared edge or vertex. There are no epsilons.
class RayTriangleTest {
 public:
  explicit RayTriangleTest(const Ray& ray) : origin_(ray.origin) {
    const dvec3 size = glm::abs(ray.direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    scale_ = 1.0 / ray.direction[z_];
    shear_x_ = ray.direction[x_] * scale_;
    shear_y_ = ray.direction[y_] * scale_;
  }

  /// Returns the hit with the triangle a b c from either side, including its rim, with 0 <= t <= t_max. A ray in the
  /// plane of the triangle misses.
  [[nodiscard]] std::optional<TriangleHit> operator()(const dvec3& a, const dvec3& b, const dvec3& c,
                                                      double t_max) const {
    const dvec3 p = sheared(a), q = sheared(b), r = sheared(c);
    const double u = r.x * q.y - r.y * q.x, v = p.x * r.y - p.y * r.x, w = q.x * p.y - q.y * p.x;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const double sum = u + v + w;
    if (sum == 0) return std::nullopt;
    const double t = (u * p.z + v * q.z + w * r.z) / sum;
    if (!(t >= 0 && t <= t_max)) return std::nullopt;
    return TriangleHit{t, dvec3(u, v, w) / sum};
  }

 private:
  /// Returns x and y across the ray, and z along it in units of t.
  [[nodiscard]] dvec3 sheared(const dvec3& point) const {
    const dvec3 p = point - origin_;
    return {p[x_] - shear_x_ * p[z_], p[y_] - shear_y_ * p[z_], scale_ * p[z_]};
  }

  dvec3 origin_;
  int x_, y_, z_;
  double shear_x_, shear_y_, scale_;
};

/// Returns the hit of a ray with one triangle within ray.t_max, as RayTriangleTest.
inline std::optional<TriangleHit> intersect_triangle(const Ray& ray, const dvec3& a, const dvec3& b, const dvec3& c) {
  return RayTriangleTest(ray)(a, b, c, ray.t_max);
}

}  // namespace taxel
