// The setups of the closed forms: the contact of two bodies at given poses, a flat patch under a linear pressure, a
// soft body on a rigid floor in MuJoCo, and the soft ball with the functions that solve its motion.
#pragma once

#include <string>

#include "core/base/material.h"
#include "core/base/random_pose.h"
#include "core/hydro/fields/round_mesh.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/mesh/tri_mesh.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/scene/loaded_scene.h"

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

/// A thin plate with 7 x 7 taxels on its upper face, away from its edges. The mean of a pressure that is linear in x
/// over any disc equals the pressure at the centre.
struct FlatPatch {
  static constexpr double kHalf = 0.010, kThickness = 0.0005;  ///< half width and thickness of the plate [m]
  static constexpr double kRadius = 0.003;                     ///< radius of a taxel [m]
  static constexpr int kTaxels = 49;
  /// p = base (1 + slope x) is 0.4 to 1.6 times the base [1/m].
  static constexpr double kSlope = 0.6 / kHalf;

  /// Builds the plate with about `samples` samples in each taxel.
  static Layout layout(double samples, std::uint64_t seed, SampleWeights weights);
  static SensorModelPtr model(const Layout& layout);
};

/// A free soft body over a rigid floor, simulated by MuJoCo with the sensor plugin, for the closed forms of dynamics.
struct SoftOnFloor {
  TriMeshPtr skin;    ///< surface of the body, around its origin
  Material material;  ///< the floor has the same friction
  double mass = 0;    ///< total mass of the body [kg]
  double center = 0;  ///< height of the centre of mass above the body's origin [m]
  double start = 0;   ///< height of the body's origin over the floor [m]
  dvec3 gravity{0, 0, -9.81};
  std::string integrator = "Euler";
  double timestep = 0.002;  ///< [s]
};

class SoftOnFloorRun {
 public:
  /// Compiles the scene. Throws Error.
  explicit SoftOnFloorRun(const SoftOnFloor& setup);
  void step(int count = 1);
  /// Returns the height of the body's origin over the floor [m].
  [[nodiscard]] double height() const { return data_->qpos[2]; }
  /// Returns the position of the body's origin [m].
  [[nodiscard]] dvec3 place() const { return {data_->qpos[0], data_->qpos[1], data_->qpos[2]}; }
  /// Returns the velocity of the body [m/s].
  [[nodiscard]] dvec3 velocity() const { return {data_->qvel[0], data_->qvel[1], data_->qvel[2]}; }
  void set_velocity(const dvec3& v);
  /// Returns the angular velocity of the body, world axes [rad/s].
  [[nodiscard]] dvec3 spin_W() const;
  /// Sets the angular velocity, in the axes of the body, which are those of the world before the first step [rad/s].
  void set_spin(const dvec3& w);
  /// Returns the kinetic and the potential energy, without the energy in a deformed skin [J].
  [[nodiscard]] double energy() const;
  /// Returns whether the body touched the floor at the beginning of the last step.
  [[nodiscard]] bool touching() const;

 private:
  CompiledScene scene_;
  DataHandle data_;
  int instance_ = -1;
};

// A star field on a sphere with the exact volume, which is its medial-axis field.
inline constexpr double kBallRadius = 0.02, kBallModulus = 5e4, kBallMass = 0.05;
inline constexpr double kGravity = 9.81;

/// Returns the ball, with edges of at most `edge` [m].
inline SoftOnFloor soft_ball(const std::string& integrator, double dissipation, double edge) {
  SoftOnFloor setup;
  setup.skin = std::make_shared<const TriMesh>(make_round_sphere(kBallRadius, edge));
  setup.material = {FieldKind::star, kBallModulus, 0, dissipation, 0.5};
  setup.mass = kBallMass;
  setup.integrator = integrator;
  return setup;
}

/// Returns the force of A1 at the depth x [N].
inline double ball_force(double x) {
  return kPi * kBallModulus * x * x * (1 - 2 * x / (3 * kBallRadius));
}

/// Returns the root of an increasing function between low and high.
template <class Function>
double root(const Function& rising, double low, double high) {
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (rising(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Returns the depth at which the ball rests [m].
inline double ball_rest_depth() {
  return root([](double x) { return ball_force(x) - kGravity * kBallMass; }, 0, kBallRadius);
}

}  // namespace taxel
