// Two bodies pressed together once, as the closed forms need it.
#pragma once

#include "core/base/random_pose.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"

namespace taxel {

/// The rotation that turns the unit vector n to +z.
inline dquat turn_up(const dvec3& n) {
  if (n.z < -0.999) return glm::angleAxis(kPi, dvec3(1, 0, 0)) * turn_up(dvec3(n.x, -n.y, -n.z));
  const dvec3 axis = glm::cross(n, dvec3(0, 0, 1));  // half-way quaternion: (1 + n.z, n x z), normalised
  return glm::normalize(dquat(1.0 + n.z, axis.x, axis.y, axis.z));
}

/// A random rotation about +z, and a random place in the plane z = 0.
inline Pose random_stand(std::uint64_t seed, int number) {
  const CounterRng rng(seed, static_cast<std::uint64_t>(number));
  return {glm::angleAxis(2 * kPi * rng.uniform(0), dvec3(0, 0, 1)), {rng.uniform(1) - 0.5, rng.uniform(2) - 0.5, 0}};
}

/// Presses pairs of bodies; keeps its memory from pose to pose.
class Press {
 public:
  Press(HydroBodyPtr a, HydroBodyPtr b) : a_(std::move(a)), b_(std::move(b)) {}
  void at(const Pose& X_WA, const Pose& X_WB) {
    X_WA_ = X_WA;
    intersect(*a_, *b_, X_WA, X_WB, surface_, workspace_);
  }
  [[nodiscard]] const ContactSurface& surface() const { return surface_; }  ///< frame A
  [[nodiscard]] Wrench wrench_A() const { return surface_.empty() ? Wrench{} : pressure_wrench(surface_); }
  [[nodiscard]] dvec3 force_W() const { return X_WA_.rotate(wrench_A().force); }  ///< on A
  /// Mean distance, along the rim, where the pressure ends, from the line through `p` along the unit vector n.
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
inline HydroBodyPtr soft_plane(double modulus, double thickness) {
  return make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {FieldKind::medial_axis, modulus, thickness, 0, 0},
                   "half-space");
}
/// A primitive with its medial-axis field.
inline HydroBodyPtr soft_primitive(ShapeType type, const dvec3& size, double modulus, double resolution) {
  return make_body({type, size, nullptr, resolution}, {FieldKind::medial_axis, modulus, 0, 0, 0}, "primitive");
}
inline std::size_t tet_count(const HydroBody& body) {
  return std::get<SoftBody>(body.geometry).field->tets().size();
}

}  // namespace taxel
