// Scenes of the predecessor of this program, which configures contact surfaces by custom fields. A numeric "cs::GEOM"
// has the modulus [Pa] (0 if rigid), the dissipation [s/m], a hint for the resolution [m], and the static and the
// dynamic friction. The numeric "cs::ApplyContactSurfaceForces" is 0 if surfaces are only sensed.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

struct OldField {
  double modulus = 0, dissipation = 0;
  double resolution = 0;  ///< hint for the length of edges [m]; 0 if there is none
  double friction = 0.5;  ///< coefficient of dynamic friction
};

struct OldFields {
  std::map<std::string, OldField> geoms;  ///< fields by geom name; only geoms of the scene
  bool apply = true;                      ///< if false, surfaces are only sensed
  std::vector<std::string> notes;         ///< notes for the user on fields that are not supported
};

/// Reads the fields of a compiled model, without the fields of geoms that the model does not have. Planes, height
/// fields and signed distance functions can only be rigid, so their modulus becomes 0 and a note is added.
OldFields old_fields(const mjModel& m);

/// Returns the keys "others", "materials" and "force" of a `taxel.sensor` on a geom, as MJCF, with the values of the
/// fields of the other geoms. Empty if the geom has no field.
std::string old_keys(const mjModel& m, const OldFields& fields, const std::string& geom);

/// Returns the keys of a `taxel.contact` for the soft geoms without a sensor, as MJCF. The keys name the contacts of
/// these geoms with each other and with rigid geoms that have a field, if MuJoCo lets the two geoms collide. Empty if
/// there are no such contacts.
std::string old_contact_keys(const mjModel& m, const OldFields& fields, const std::vector<std::string>& sensing);

/// Returns a sensor for a soft box without one, with a taxel for each 25 mm square of the face towards +z, like the
/// flat sensor of the predecessor without further settings. Null for other shapes, which have contact without taxels.
/// Throws Error if the box would have more than 4096 taxels.
SensorModelPtr old_sensor(const mjModel& m, int geom, const OldField& field);

}  // namespace taxel
