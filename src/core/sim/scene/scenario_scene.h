// Builds the scene of a scenario around any layout.
//
// World: the edge of the object is the line x = 0, z = top. A box fills x > 0, z < top; an `edge` is on both sides of x
// = 0. The axis `distal` of the finger points forward (+x) and down, so the tip crosses the edge first in a sweep. The
// axis `pad` points back and down, towards the edge. The width axis (`distal` x `pad`) is +y. The demo of the paper has
// another world, see motion.h.
#pragma once

#include "core/run/motion/motion.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {

struct ScenarioScene {
  SceneFiles files;        ///< scene that names the layout file
  std::string hosted_xml;  ///< MJCF of the scene for a program that hands the compiled sensor over
  Motion motion;
  std::vector<std::string> repairs;  ///< a sentence if the object's mesh was repaired
};

/// Names of the scene's geoms.
inline constexpr const char* kFingerGeom = "finger";
inline constexpr const char* kObjectGeom = "box";

/// Throws Error that names `file` if a model has no taxels. The message says how to add taxels.
void check_has_taxels(const SensorModel& model, const std::string& file);

/// Builds the scene. Throws Error if the model has no taxels, a value of the scenario is out of range, or an object
/// mesh or a recording cannot be read.
ScenarioScene build_scenario_scene(const SensorModel& model, const Scenario& scenario);

}  // namespace taxel
