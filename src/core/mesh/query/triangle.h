// Queries of one triangle: its nearest point, its hit by a ray, and the interpolated normal of the mesh there.
#pragma once

#include <optional>
#include <tuple>

#include "core/base/math.h"
#include "core/mesh/query/bvh.h"
#include "core/mesh/tri_mesh.h"

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

/// Returns the vertex normals interpolated with the weights of a face's corners, normalised (Phong 1975). The result is
/// continuous across edges. It is the face's normal where the vertex normals cancel out.
inline dvec3 skin_normal_at_weights(const TriMesh& mesh, int face, const dvec3& barycentric) {
  const ivec3& corners = mesh.faces()[static_cast<std::size_t>(face)];
  dvec3 n(0);
  for (int c = 0; c < 3; ++c) n += barycentric[c] * mesh.vertex_normals()[static_cast<std::size_t>(corners[c])];
  const double length = glm::length(n);
  return length > 0.0 && std::isfinite(length) ? n / length : mesh.face_normals()[static_cast<std::size_t>(face)];
}

/// Returns the interpolated unit normal at the point of a face that is nearest to `point`.
inline dvec3 skin_normal(const TriMesh& mesh, int face, const dvec3& point) {
  const TrianglePoint at = nearest_on_triangle(point, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
  return skin_normal_at_weights(mesh, face, at.barycentric);
}

}  // namespace taxel
