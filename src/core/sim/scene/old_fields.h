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
  double modulus = 0, dissipation = 0;
  double resolution = 0;  ///< hint for the length of edges [m]; 0: none
  double friction = 0.5;  ///< the dynamic one
};

struct OldFields {
  std::map<std::string, OldField> geoms;  ///< those that the scene has
  bool apply = true;
  std::vector<std::string> notes;  ///< for the user: fields that cannot be followed
};

/// Reads the fields of a compiled model. Fields of geoms that it does not have are left out. Planes, height fields and
/// signed distance functions can only be rigid: their modulus becomes 0, with a note.
OldFields old_fields(const mjModel& m);

/// Returns the keys "others", "materials" and "force" of a `taxel.sensor` on that geom, as MJCF: the values that the
/// fields give the other geoms. Empty if the geom has no field.
std::string old_keys(const mjModel& m, const OldFields& fields, const std::string& geom);

/// Returns the keys of a `taxel.contact` for the soft geoms that have no sensor, as MJCF: their contacts with each
/// other and with rigid geoms that have a field, as far as MuJoCo lets them collide. Empty if there are none.
std::string old_contact_keys(const mjModel& m, const OldFields& fields, const std::vector<std::string>& sensing);

/// A sensor for a soft geom that has none: one taxel for each 25 mm of the face of a box that looks along +z, as the
/// predecessor's flat sensor without further settings. Null for other shapes, which need no taxels to have contact.
SensorModelPtr old_sensor(const mjModel& m, int geom, const OldField& field);

}  // namespace taxel
