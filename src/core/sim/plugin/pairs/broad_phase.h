// Which of the geoms that a sensor touches are near it.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/hydro/hydro_body.h"

namespace taxel {

/// Bounding spheres about the origins of geoms, whose positions MuJoCo has computed already: a few nanoseconds each,
/// and right whatever moves, or is moved by the program that owns the model.
class BroadPhase {
 public:
  void clear();
  /// Geom number size(), with nothing on it yet.
  void add(int geom);
  /// The body of a geom, whose frame has the pose X_GB in the geom's.
  void set_body(std::size_t number, const HydroBody& body, const Pose& X_GB);
  void remove_body(std::size_t number);

  /// Numbers of the geoms whose bodies may meet a sphere, ascending. Keeps the memory of `near`.
  void find(const mjData& d, const dvec3& center_W, double radius, std::vector<std::size_t>& near) const;

 private:
  std::vector<int> geoms_;
  std::vector<double> radii_;  // negative: no body; infinite: a half-space [m]
};

}  // namespace taxel
