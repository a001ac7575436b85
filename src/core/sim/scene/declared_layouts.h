// Other layouts for the sensors that a scene's file declares, in the text of the scene. The C++ types of MuJoCo's
// function mjs_setPluginAttributes() are those of another standard library.
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"
#include "core/sim/scene/mjcf_source.h"

namespace taxel {

/// Returns the instance of the sensor that a scene declares on a geom. Throws Error naming the scene if there is none.
int declared_instance(const mjModel& m, const std::string& geom, const std::string& scene);

/// Returns the element `<config key="layout">` of an instance. Throws Error naming the scene if its text has none, as
/// for an instance that `<replicate>` or `<attach>` makes.
int layout_element(const MjcfSource& source, const std::string& instance, const std::string& scene);

/// Returns the texts, by path, of the files of a scene that change if instances, by their names, take models that the
/// program hands over: the keys on which the sizes of output and state depend replace the key `layout`. Throws Error as
/// layout_element() does.
std::map<std::filesystem::path, std::string> texts_for_models(const MjcfSource& source,
                                                              const std::map<std::string, SensorModelPtr>& models,
                                                              const std::string& scene);

/// A layout that a scene declares for a sensor.
struct DeclaredLayout {
  /// File of the layout. For a layout that is text in the scene, a file in the folder of its mesh that need not exist.
  std::filesystem::path file;
  bool is_text = false;       ///< the scene has the layout itself as text
  bool is_unchanged = false;  ///< the declared layout is equal to that of the model
};

/// Compares the layout that an instance declares with that of a model.
DeclaredLayout declared_layout(const mjModel& m, int instance, const SensorModel& model);

}  // namespace taxel
