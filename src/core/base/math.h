// Vectors, rigid poses, boxes, angles and indices: the vocabulary of every other folder.
//
// Names contain frames: p_W is a point in the world frame W, X_WG the pose of the geom frame G in W, so that p_W = X_WG
// * p_G. Lengths are in metres, angles in radians.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// Returns the angle between two directions of any length, 0 to pi. It is as exact near 0 as anywhere.
inline double angle_between(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Returns the angle between two directions of any length, 0 to 180 degrees.
inline double angle_deg(const dvec3& a, const dvec3& b) {
  return angle_between(a, b) * 180.0 / kPi;
}

/// Returns the index i, which must not be negative, in the type that containers take: v[at(i)]. Indices are stored as
/// int because a mesh, a layout or a surface has fewer than 2^31 parts, and int takes half the memory.
[[nodiscard]] constexpr std::size_t at(int i) noexcept {
  return static_cast<std::size_t>(i);
}

}  // namespace taxel
