// The sensors that are added to a scene: layouts of other programs on its geoms, and the collision geoms ("sisters")
// within their skins. Robots have a visual mesh, on which the sensor is, and simpler geoms in the same place, whose
// contacts would carry the load instead of the skin.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/layout_format.h"
#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/plugin/skin_bits.h"

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

/// Returns the geoms with the mesh asset of this name, one for each place: of geoms with the same pose in one body,
/// which are the visual and the collision geom of a robot, the first. Throws Error naming `file` if there is no such
/// mesh, or no geom has it.
std::vector<int> geoms_of_mesh(const mjModel& m, const std::string& mesh, const std::string& file);

/// Throws Error naming the layout unless the geom can have a skin on which the taxels are: the geom has a surface with
/// an inside (a plane, a height field or a flex has none), and no taxel is farther from this surface than a quarter of
/// its extent.
void expect_layout_on_geom(const mjModel& m, int geom, const SensorModel& model, const std::string& layout);

// Layouts of other programs on the geoms of a scene. The file names the geom; the geom gives the mesh and the material.

/// Reads the layout of an attachment. If the file has several sensors, it is the requested one, otherwise the one on
/// the geom of the attachment, otherwise the first. Throws Error naming file and place.
ImportedLayout read_attached_layout(const SceneAttachment& attachment);

/// Places the layout on the mesh of the attachment, or on the mesh of the geom if the attachment has none, and compiles
/// the layout. A field "cs::GEOM" of the scene gives the material. Adds a note for each value that is not in the file.
/// Throws Error naming file and place if there is no such geom, or its shape is neither a mesh file nor a box.
SensorModelPtr compile_attached_layout(const SceneAttachment& attachment, ImportedLayout imported,
                                       const std::string& geom, const mjModel& scene, std::vector<std::string>& notes);

/// A sensor that is added to a scene.
struct AddedSensor {
  std::string instance, geom, keys;          ///< `keys` are more plugin keys, as MJCF
  SensorModelPtr model;                      ///< model; null until the scene is known, for layouts of other programs
  const SceneAttachment* foreign = nullptr;  ///< request for a layout of another program, or null
  ImportedLayout imported = {};
  bool keeps_sisters = false;  ///< SceneAttachment::keeps_sisters
};

/// Returns the geoms from which MuJoCo's own contacts are taken, each with the geom of its sensor, and adds notes that
/// name them: the collision geoms within the skins of the added sensors, and the geom of a sensor itself if other geoms
/// of its body keep their contacts, so that no <exclude> can replace its own. The skin must touch all that such a geom
/// can touch: otherwise the geom keeps its contacts.
std::map<int, int> replaced_sisters(const mjModel& m, std::vector<AddedSensor>& added, std::vector<std::string>& notes);

/// Gives each added sensor the bits of contact of the geoms that it replaces, as keys. Without the contacts of these
/// geoms, nothing else in the scene says which geoms the skin touches.
void give_bits(const mjModel& m, const std::map<int, int>& sisters, std::vector<AddedSensor>& added);

/// Returns the plugin keys of bits of contact, as MJCF.
std::string bits_keys(const ContactBits& bits);

}  // namespace taxel
