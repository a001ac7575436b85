// One free soft body over a rigid floor, stepped by MuJoCo with the sensor plugin: what the closed forms of dynamics
// need.
#pragma once

#include <string>

#include "core/base/material.h"
#include "core/mesh/tri_mesh.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {

struct SoftOnFloor {
  TriMeshPtr skin;    ///< around the body's origin
  Material material;  ///< friction also of the floor
  double mass = 0;    ///< [kg], spread evenly ...
  double center = 0;  ///< ... about this height above the body's origin [m]
  double start = 0;   ///< height of the body's origin over the floor [m]
  dvec3 gravity{0, 0, -9.81};
  std::string integrator = "Euler";
  double timestep = 0.002;  ///< [s]
};

class SoftOnFloorRun {
 public:
  /// Throws Error, as a scene that cannot be compiled does.
  explicit SoftOnFloorRun(const SoftOnFloor& setup);
  void step(int count = 1);
  [[nodiscard]] double height() const { return data_->qpos[2]; }  ///< of the body's origin over the floor [m]
  [[nodiscard]] dvec3 velocity() const { return {data_->qvel[0], data_->qvel[1], data_->qvel[2]}; }  ///< [m/s]
  void set_velocity(const dvec3& v);
  /// Kinetic energy and that of the height, without what a pressed skin stores [J].
  [[nodiscard]] double energy() const;
  [[nodiscard]] bool touching() const;  ///< in the state that the last step began with

 private:
  CompiledScene scene_;
  DataHandle data_;
  int instance_ = -1;
};

}  // namespace taxel
