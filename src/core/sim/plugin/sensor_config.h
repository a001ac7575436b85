// The configuration of one `taxel.sensor` instance, as the MJCF says it (docs/plugin.md lists the keys).
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "core/base/material.h"
#include "core/sim/plugin/layout_search.h"

namespace taxel {

/// Blocks of values in `sensordata`.
enum class Output {
  readings,  ///< one per taxel, the layout's aggregate of the elastic pressure
  wrench,    ///< 6: force [N], then torque [N m] about the origin of the mesh-file frame, on the sensor, world axes
  area       ///< 1: of the contact surfaces [m^2]
};

/// What the key `materials` says of one touched geom.
struct OtherMaterial {
  Material material;          ///< rigid unless `modulus` is given
  bool has_friction = false;  ///< otherwise the geom's own sliding friction counts
  bool has_field = false;     ///< otherwise medial axis for primitives, pad for meshes
  double resolution = 0;      ///< of the tessellation [m]; 0: chosen
  bool operator==(const OtherMaterial&) const = default;
};
using OtherMaterials = std::map<std::string, OtherMaterial>;

/// The part of a configuration that says which contacts of a geom are computed: that of a sensor, or that of a soft
/// geom of a `taxel.contact`.
struct ContactSettings {
  std::string name;           ///< name of the instance, for messages
  int geom = -1;              ///< geom whose contacts are computed
  std::string geom_name;      ///< its name
  std::vector<int> others;    ///< geoms it touches, ascending
  bool others_named = false;  ///< the configuration names `others`: one that cannot be touched is an error
  OtherMaterials materials;   ///< by geom name
  bool apply = true;          ///< forces move bodies; otherwise they are sensed only
};

struct SensorConfig : ContactSettings {
  std::string layout;     ///< value of the key `layout`; empty when the program hands the sensor over
  int handed_taxels = 0;  ///< value of the key `taxels`: how many taxels the handed-over sensor has
  std::vector<Output> output{Output::readings};
};

/// Reading configuration keys, for all plugins of this folder. All throw Error whose place is the key.
std::string config_value(const mjModel& m, int instance, const char* key);  ///< empty if not given
std::vector<std::string> split_words(std::string text);                     ///< at spaces and commas
int geom_by_name(const mjModel& m, const std::string& name, const char* key);
std::vector<Output> read_output(const std::string& value, const std::vector<Output>& allowed);
bool read_force(const mjModel& m, int instance);  ///< true for "apply", which is the default
OtherMaterials read_materials(const mjModel& m, int instance);

/// Name of the instance for messages.
std::string instance_name(const mjModel& m, int instance);

/// Reads and checks all keys but the layout's content. Throws Error whose place is the key.
SensorConfig read_sensor_config(const mjModel& m, int instance);

/// Length of the instance's part of `sensordata`. Callable while the model is being built, when only names, bodies,
/// geoms, configuration and asset paths are there. Throws Error.
int sensor_dimension(const mjModel& m, int instance);
int sensor_dimension(const std::vector<Output>& output, int taxels);

/// Folders in which a layout named by a relative path is looked for: that of the geom's mesh file, which stands beside
/// the scene as a rule, those of the scene's other mesh files, then the working directory.
std::vector<std::filesystem::path> layout_folders(const mjModel& m, int geom);

/// Parses the key `materials`. Throws Error(file, JSON pointer, message).
OtherMaterials parse_materials(const std::string& text, const std::string& file);

}  // namespace taxel
