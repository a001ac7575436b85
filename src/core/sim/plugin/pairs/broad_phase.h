// Broad phase: finds the touched geoms that are near a sensor.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/hydro/hydro_body.h"

namespace taxel {

/// Bounding spheres about the origins of geoms. MuJoCo has already computed the positions of the origins, so the test
/// costs a few nanoseconds for each geom and remains correct when geoms move for any reason.
class BroadPhase {
 public:
  void clear();
  /// Adds a geom without a body. Numbers are given in the order of calls, from 0.
  void add(int geom);
  /// Sets the body of a geom. X_GB is the pose of the body's frame in the geom's frame.
  void set_body(std::size_t number, const HydroBody& body, const Pose& X_GB);
  void remove_body(std::size_t number);

  /// Sets `near` to the numbers of the geoms whose bodies may touch a sphere, ascending. Reuses the memory of `near`.
  void find(const mjData& d, const dvec3& center_W, double radius, std::vector<std::size_t>& near) const;

 private:
  std::vector<int> geoms_;
  std::vector<double> radii_;  // radii [m]; negative without a body, infinite for a half-space
};

}  // namespace taxel
