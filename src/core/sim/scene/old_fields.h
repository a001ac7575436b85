// Scenes of the predecessor's code: contact surfaces configured by custom fields of the scene. A numeric "cs::GEOM" has
// modulus [Pa] (0: rigid), dissipation [s/m], a hint for the resolution [m], static and dynamic friction; the numeric
// "cs::ApplyContactSurfaceForces" is 0 where surfaces are only sensed.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

struct OldField {
  double modulus = 0, dissipation = 0, friction = 0.5;  ///< friction: the dynamic one
};

struct OldFields {
  std::map<std::string, OldField> geoms;  ///< those that the scene has
  bool apply = true;
};

/// Of a compiled model. Fields of geoms that it does not have are left out.
OldFields old_fields(const mjModel& m);

/// The keys "others", "materials" and "force" of a `taxel.sensor` on that geom, as MJCF: what the fields say of the
/// others. Empty where the geom has no field.
std::string old_keys(const OldFields& fields, const std::string& geom);

/// A sensor for a soft geom that has none: one taxel for each 25 mm of the face of a box that looks along +z, as the
/// predecessor's flat sensor without further settings. Null for other shapes.
SensorModelPtr old_sensor(const mjModel& m, int geom, const OldField& field);

}  // namespace taxel
