// A free soft body over a rigid floor, simulated by MuJoCo with the sensor plugin, for the closed forms of dynamics.
#pragma once

#include <string>

#include "core/base/material.h"
#include "core/mesh/tri_mesh.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {

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

}  // namespace taxel
