// The configuration of one instance of `taxel.sensor` or `taxel.contact`, read from its MJCF keys (docs/plugin.md), and
// the size of its output.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <utility>
#include <vector>

#include "core/sim/plugin/layout_search.h"
#include "core/sim/plugin/materials.h"
#include "core/sim/plugin/plugin_instances.h"

namespace taxel {

/// Blocks of values in `sensordata`.
enum class Output {
  readings,  ///< one value per taxel: the layout's aggregate of the elastic pressure
  /// Six values: force [N], then torque [N m] about the origin of the mesh-file frame; on the sensor, world axes.
  wrench,
  elastic_wrench,  ///< six values like `wrench`, of the elastic pressure alone: no damping, no friction
  area,            ///< one value: area of the contact surfaces [m^2]
  slip,            ///< one value per taxel: share of its field that slips, from 0 to 1
  calibrated       ///< one value per taxel: the value that the layout's device reports
};

/// Friction that sticks (hydro/bristles.h).
struct BristleSettings {
  double stiffness = 0;  ///< tangential stiffness per area [Pa/m]; 0 for regularised friction
  int count = 1000;      ///< number of bristles on the skin
  bool given = false;    ///< true if the configuration has the keys, not the layout
  [[nodiscard]] bool has_bristles() const { return stiffness > 0; }
};

/// The part of a configuration that selects the computed contacts of one geom: the geom of a sensor, or a soft geom of
/// a `taxel.contact`.
struct ContactSettings {
  std::string name;           ///< name of the instance, for messages
  int geom = -1;              ///< geom whose contacts are computed
  std::string geom_name;      ///< present name of `geom`
  std::vector<int> others;    ///< geoms that `geom` touches, ascending
  bool others_named = false;  ///< the configuration names `others`, so one that cannot be touched is an error
  OtherMaterials materials;   ///< materials of touched geoms, by present geom name; kAllGeoms for all others
  bool apply = true;          ///< forces move bodies; otherwise they are sensed only
  BristleSettings bristles;   ///< friction of the contacts that this body computes
};

/// All keys of one `taxel.sensor`.
struct SensorConfig : ContactSettings {
  std::string layout;     ///< value of the key `layout`; empty if the program hands the sensor over
  int handed_taxels = 0;  ///< value of the key `taxels`: number of taxels of the handed-over sensor
  std::vector<Output> output{Output::readings};
};

// Functions that read configuration keys, for all plugins of this folder.

std::vector<std::string> split_words(std::string text);  ///< words between spaces and commas
/// Reads the key `output`. Throws Error whose place is the key unless each word is in `allowed`.
std::vector<Output> read_output(const std::string& value, const std::vector<Output>& allowed);
/// Reads the key `force`. Returns true for "apply", which is the default. Throws Error whose place is the key.
bool read_force(const mjModel& m, int instance);
/// Reads the keys `tangential_stiffness` and `bristles`. Throws Error whose place is the key.
BristleSettings read_bristles(const mjModel& m, int instance);
/// Reads the key `materials`, by present geom names or kAllGeoms. Throws Error whose place is the key.
OtherMaterials read_materials(const mjModel& m, int instance);

/// Returns the friction of a sensor with this layout: that of the configuration if it has the keys, or the layout's.
BristleSettings bristles_with_layout(const BristleSettings& keys, const Layout& layout);
/// Throws Error whose place is the key if slip is in the output but friction does not stick.
void check_slip_output(const SensorConfig& config);
/// Returns whether a word is in the output of a sensor.
bool has_output(const SensorConfig& config, Output block);
/// Throws Error whose place is the key if calibrated values are in the output of a layout without a calibration.
void check_calibrated_output(const SensorConfig& config, const Layout& layout);
/// Returns the number of state values of the chain of a sensor's taxels; 0 unless calibrated values are in the output.
/// It can be called while the model is being built. Throws Error if a key is not valid or the layout cannot be read.
int chain_state_size(const mjModel& m, int instance);

/// Returns bristles_with_layout() of an instance, and reads its layout if need be. It can be called while the model is
/// being built. Throws Error if a key is not valid or the layout cannot be read.
BristleSettings sensor_bristles(const mjModel& m, int instance);

/// Reads and checks all keys, but not the content of the layout. Throws Error whose place is the key.
SensorConfig read_sensor_config(const mjModel& m, int instance);

/// Returns the length of the instance's part of `sensordata`. It can be called while the model is being built, when
/// only names, bodies, geoms, configuration and asset paths exist. Throws Error if a key is not valid.
int sensor_dimension(const mjModel& m, int instance);
int sensor_dimension(const std::vector<Output>& output, int taxels);

/// Returns the folders in which a layout with a relative path is searched, in this order: the folder of the geom's mesh
/// file, which is usually next to the scene, the folders of the scene's other mesh files, and the working directory.
/// `geom` is -1 if the geom is not known.
std::vector<std::filesystem::path> layout_folders(const mjModel& m, int geom);

/// All keys of one `taxel.contact`: soft contact between geoms without taxels.
struct ContactConfig {
  std::string name;                     ///< name of the instance, for messages
  OtherMaterials materials;             ///< materials of geoms, by geom name
  std::vector<ContactSettings> bodies;  ///< the soft geoms without a sensor, ascending by geom
  /// Named pairs, the smaller geom first, ascending. If empty, all pairs of geoms that collide.
  std::vector<std::pair<int, int>> pairs;
  bool apply = true;           ///< forces move bodies; otherwise they are sensed only
  BristleSettings bristles;    ///< friction of the soft geoms
  std::vector<Output> output;  ///< outputs of each body, in the order of `bodies`
};

/// Reads and checks all keys. Throws Error whose place is the key if a geom does not exist or is named twice, a pair
/// has two rigid geoms, or there are materials but no soft geom.
ContactConfig read_contact_config(const mjModel& m, int instance);

/// Returns the length of the instance's part of `sensordata`. Like sensor_dimension(), it can be called while the model
/// is being built.
int contact_dimension(const mjModel& m, int instance);

}  // namespace taxel
