// The scene of a scenario, built around any layout.
//
// World: the object's edge is the line x = 0, z = top. A box fills x > 0, z < top; an `edge` lies on both sides of x =
// 0. `distal` of the finger points forward (+x) and down, so that in a sweep the tip leads over the edge, and `pad`,
// behind and below it, faces the edge. Its width axis (`distal` x `pad`) is +y. The demo of the paper has a world of
// its own, see paper_demo.h.
#pragma once

#include "core/run/motion/motion.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/scene/scene_files.h"

namespace taxel {

struct ScenarioScene {
  SceneFiles files;        ///< scene.xml names the layout file
  std::string hosted_xml;  ///< the same, for a program that hands the compiled sensor over
  Motion motion;
};

/// Names of the scene's geoms.
inline constexpr const char* kFingerGeom = "finger";
inline constexpr const char* kObjectGeom = "box";

/// Throws Error that names `file` if a model has no taxels, and says where taxels come from.
void check_has_taxels(const SensorModel& model, const std::string& file);

/// Throws Error for a model without taxels, scenario values out of range, or an object mesh or recording that cannot be
/// read.
ScenarioScene build_scenario_scene(const SensorModel& model, const Scenario& scenario);

}  // namespace taxel
