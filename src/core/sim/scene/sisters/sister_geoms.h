// Collision geoms of a sensor's body that lie within its skin, at least for the larger part. Robots have a visual mesh,
// on which the sensor is, and simpler geoms in the same place, whose contacts would carry the load instead of the skin.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// A geom of the sensor's body.
struct Sister {
  int geom = -1;
  double share = 1;  ///< share of its surface that lies within the skin
};

/// Returns the geoms of the body of `geom` that can collide and of which at least half of the surface lies within the
/// sensor's skin, or at most the thickness of its pad or 2 % of the skin's diagonal outside of it. `geom` has the
/// sensor.
std::vector<Sister> sister_geoms(const mjModel& m, int geom, const SensorModel& model);

/// Returns the only geom of a body with a mesh, or the first one if all of its mesh geoms have the same mesh. Throws
/// Error naming `file` if there is no such body, if the body has no mesh, or if it has several.
int mesh_geom_of_body(const mjModel& m, const std::string& body, const std::string& file);

}  // namespace taxel
