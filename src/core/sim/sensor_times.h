// Where the time of sensors goes.
#pragma once

namespace taxel {

/// Wall time spent since the sensor was made [s].
struct SensorTimes {
  double surfaces = 0;  ///< poses, broad phase, contact surfaces
  double forces = 0;    ///< tractions, the implicit step, what is handed to MuJoCo
  double readings = 0;  ///< rays and aggregates
};

}  // namespace taxel
