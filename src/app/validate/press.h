// The contact of two bodies at given poses, for the closed forms.
#pragma once

#include "core/base/random_pose.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"

namespace taxel {

/// Returns the rotation that turns the unit vector n to +z.
inline dquat turn_up(const dvec3& n) {
  if (n.z < -0.999) return glm::angleAxis(kPi, dvec3(1, 0, 0)) * turn_up(dvec3(n.x, -n.y, -n.z));
  const dvec3 axis = glm::cross(n, dvec3(0, 0, 1));  // the quaternion is (1 + n.z, n x z), normalised
  return glm::normalize(dquat(1.0 + n.z, axis.x, axis.y, axis.z));
}

/// Returns a random rotation about +z and a random position in the plane z = 0.
inline Pose random_stand(std::uint64_t seed, int number) {
  const CounterRng rng(seed, static_cast<std::uint64_t>(number));
  return {glm::angleAxis(2 * kPi * rng.uniform(0), dvec3(0, 0, 1)), {rng.uniform(1) - 0.5, rng.uniform(2) - 0.5, 0}};
}

/// Computes the contact of two bodies at many poses with the same memory.
class Press {
 public:
  Press(HydroBodyPtr a, HydroBodyPtr b) : a_(std::move(a)), b_(std::move(b)) {}
  void at(const Pose& X_WA, const Pose& X_WB) {
    X_WA_ = X_WA;
    intersect(*a_, *b_, X_WA, X_WB, surface_, workspace_);
  }
  /// Returns the contact surface in frame A.
  [[nodiscard]] const ContactSurface& surface() const { return surface_; }
  [[nodiscard]] Wrench wrench_A() const { return surface_.empty() ? Wrench{} : pressure_wrench(surface_); }
  /// Returns the force on A in the world frame.
  [[nodiscard]] dvec3 force_W() const { return X_WA_.rotate(wrench_A().force); }
  /// Returns the mean distance of the rim, at which the pressure is 0, from the line through `p` along the unit vector
  /// n.
  [[nodiscard]] double rim_radius(const dvec3& p_A, const dvec3& n_A) const {
    const double zero = 1e-9 * surface_.max_pressure();
    const auto distance = [&](const dvec3& v) { return glm::length(glm::cross(v - p_A, n_A)); };
    double sum = 0, length = 0;
    for (const ContactPolygon& polygon : surface_.polygons) {
      for (int k = 0; k < polygon.count; ++k) {
        const auto i = static_cast<std::size_t>(polygon.first + k);
        const auto j = static_cast<std::size_t>(polygon.first + (k + 1) % polygon.count);
        if (surface_.pressure[i] > zero || surface_.pressure[j] > zero) continue;
        const dvec3 &a = surface_.vertices[i], &b = surface_.vertices[j];
        const double edge = glm::distance(a, b);
        sum += edge * (distance(a) + 4 * distance(0.5 * (a + b)) + distance(b)) / 6;  // Simpson's rule
        length += edge;
      }
    }
    return sum / length;
  }

 private:
  HydroBodyPtr a_, b_;
  Pose X_WA_;
  ContactSurface surface_;
  IntersectWorkspace workspace_;
};

inline HydroBodyPtr rigid_plane() {
  return make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {}, "plane");
}
inline HydroBodyPtr soft_plane(double modulus, double thickness, FaceRule faces = FaceRule::along_gradient) {
  Material material{FieldKind::medial_axis, modulus, thickness, 0, 0};
  material.faces = faces;
  return make_body({ShapeType::plane, dvec3(0), nullptr, 0}, material, "half-space");
}
/// Returns a primitive with its medial-axis field.
inline HydroBodyPtr soft_primitive(ShapeType type, const dvec3& size, double modulus, double resolution) {
  return make_body({type, size, nullptr, resolution}, {FieldKind::medial_axis, modulus, 0, 0, 0}, "primitive");
}
inline std::size_t tet_count(const HydroBody& body) {
  return std::get<SoftBody>(body.geometry).field->tets().size();
}

}  // namespace taxel
