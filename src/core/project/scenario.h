// What happens in a built scene: plain values that a project file holds and a user edits.
#pragma once

#include <string>

#include "core/base/math.h"

namespace taxel {

/// The fingertip sweep of the paper. The finger, tilted, is held by a weld to a mocap body whose path leads straight
/// over the edge of a box, at right angles to it.
struct SweepScenario {
  double depth = 0.0015;        ///< below first touch on the box's top [m]
  double speed = 0.010;         ///< of the mocap body [m/s]
  double before = 0.012;        ///< start: lowest point of the finger this far outside of the edge [m]
  double past = 0.012;          ///< end: this far inside [m]
  double tilt_deg = 45.0;       ///< of `distal` below the horizontal
  double record_every = 0.0001; ///< a row per this travel [m]
  double timestep = 0.001;      ///< [s]
  double finger_mass = 0.020;   ///< [kg]
  double box_size = 0.050;      ///< edge length [m]
  std::string object;           ///< mesh file of the object; empty: the box
  bool operator==(const SweepScenario&) const = default;
};

}  // namespace taxel
