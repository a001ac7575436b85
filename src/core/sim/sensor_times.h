// The computing time of sensors, by kind of work.
#pragma once

namespace taxel {

/// Wall time since the sensor was created [s].
struct SensorTimes {
  double surfaces = 0;  ///< time for poses, broad phase and contact surfaces
  double forces = 0;    ///< time for tractions, the implicit step and passing forces to MuJoCo
  double readings = 0;  ///< time for rays and aggregates
};

}  // namespace taxel
