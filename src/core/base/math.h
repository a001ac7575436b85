// Vectors, rigid poses and boxes: the vocabulary of every other folder.
//
// Names contain frames: p_W is a point in the world frame W, X_WG the pose of the geom frame G in W, so that p_W = X_WG
// * p_G. Lengths are in metres, angles in radians.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace taxel {

using glm::dmat3;
using glm::dquat;
using glm::dvec2;
using glm::dvec3;
using glm::ivec3;
using glm::ivec4;

inline constexpr double kPi = 3.14159265358979323846;

/// A rigid pose: rotation by the unit quaternion q (w x y z), then translation by p.
struct Pose {
  dquat q{1.0, 0.0, 0.0, 0.0};
  dvec3 p{0.0};

  /// The rotation as a matrix (columns are the axes of the inner frame).
  [[nodiscard]] dmat3 rotation() const { return glm::mat3_cast(q); }
  [[nodiscard]] Pose inverse() const {
    const dquat qi = glm::conjugate(q);
    return {qi, -(glm::mat3_cast(qi) * p)};
  }
  [[nodiscard]] dvec3 rotate(const dvec3& v) const { return rotation() * v; }
};

inline Pose operator*(const Pose& X_AB, const Pose& X_BC) {
  return {X_AB.q * X_BC.q, X_AB.p + X_AB.rotation() * X_BC.p};
}
inline dvec3 operator*(const Pose& X_AB, const dvec3& p_B) {
  return X_AB.p + X_AB.rotation() * p_B;
}

/// A pose with its rotation expanded to a matrix, for loops over many points.
struct RigidTransform {
  dmat3 R{1.0};
  dvec3 p{0.0};
  RigidTransform() = default;
  explicit RigidTransform(const Pose& X) : R(X.rotation()), p(X.p) {}
  dvec3 operator()(const dvec3& v) const { return R * v + p; }
  [[nodiscard]] dvec3 inverse_point(const dvec3& v) const { return (v - p) * R; }  // R^T (v - p)
};

/// Axis-aligned box; empty until something is included.
struct Aabb {
  dvec3 lo{std::numeric_limits<double>::infinity()};
  dvec3 hi{-std::numeric_limits<double>::infinity()};

  void include(const dvec3& p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  void include(const Aabb& b) {
    lo = glm::min(lo, b.lo);
    hi = glm::max(hi, b.hi);
  }
  [[nodiscard]] bool empty() const { return !(lo.x <= hi.x); }
  [[nodiscard]] dvec3 center() const { return 0.5 * (lo + hi); }
  [[nodiscard]] dvec3 extent() const { return hi - lo; }
  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : glm::length(hi - lo); }
  [[nodiscard]] double surface_area() const {
    if (empty()) return 0.0;
    const dvec3 e = extent();
    return 2.0 * (e.x * e.y + e.y * e.z + e.z * e.x);
  }
  [[nodiscard]] bool overlaps(const Aabb& b) const {
    return lo.x <= b.hi.x && b.lo.x <= hi.x && lo.y <= b.hi.y && b.lo.y <= hi.y && lo.z <= b.hi.z && b.lo.z <= hi.z;
  }
};

/// Returns a unit vector at right angles to the unit vector n.
inline dvec3 any_perpendicular(const dvec3& n) {
  const dvec3 axis = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(glm::cross(n, axis));
}

inline bool is_finite(const dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace taxel
