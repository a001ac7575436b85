// The instances of the plugins `taxel.sensor` and `taxel.contact` in a model.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

namespace taxel {

inline constexpr const char* kPluginName = "taxel.sensor";
inline constexpr const char* kContactPluginName = "taxel.contact";

/// The configuration keys of each plugin. MuJoCo refuses any other key.
inline constexpr const char* kSensorKeys[] = {"layout",
                                              "geom",
                                              "others",
                                              "other_ids",
                                              "contype",
                                              "conaffinity",
                                              "materials",
                                              "force",
                                              "output",
                                              "taxels",
                                              "tangential_stiffness",
                                              "bristles"};
inline constexpr const char* kContactKeys[] = {"materials", "pairs", "geoms", "force", "output", "tangential_stiffness",
                                               "bristles"};

/// Returns true if the plugin of a slot is registered and has that name.
bool is_plugin(int slot, const char* name);

/// Returns the instances of `taxel.sensor`, ascending.
std::vector<int> sensor_instances(const mjModel& m);
/// Returns the instances of `taxel.contact`, ascending.
std::vector<int> contact_instances(const mjModel& m);

// The geoms that a configuration names. MjSpec.attach() puts a prefix before and a suffix behind the names of geoms and
// instances, and `<replicate>` a number behind them, but the names in the text of a configuration remain as written.

/// The name that means all geoms, in the keys `others` and `materials` of a sensor.
inline constexpr const char* kAllGeoms = "*";

/// Returns the value of a key; empty if not given.
std::string config_value(const mjModel& m, int instance, const char* key);
/// Returns the name of the instance, for messages: without one that of its sensor, or "#3".
std::string instance_name(const mjModel& m, int instance);

/// Texts that MuJoCo has put around a name.
struct Affixes {
  std::string prefix, suffix;
};

/// Finds geoms by the names in the configuration of one instance.
class GeomNames {
 public:
  GeomNames(const mjModel& m, int instance);

  /// Returns the geom of a name as written or, if there is none, of the name with the prefix and suffix of the
  /// instance. Throws Error whose place is `key` if there is neither.
  [[nodiscard]] int find(const std::string& name, const char* key) const;

  /// Returns the sensor's geom: the one to which an entry under `<sensor>` refers (objtype="geom" objname="..."), which
  /// MuJoCo renames, otherwise that of the key `geom`. Returns -1 if there is neither. Throws Error if the key names no
  /// geom, or another one than the entry. While MuJoCo builds a model, entries refer to nothing yet.
  [[nodiscard]] int sensor_geom() const;

 private:
  [[nodiscard]] int find_or_none(const std::string& name) const;

  const mjModel& m_;
  std::string geom_;              // value of the key `geom`
  int referred_ = -1;             // geom to which the entry under <sensor> refers
  std::vector<Affixes> affixes_;  // texts that the instance may have got around its name, in the order of search
};

}  // namespace taxel
