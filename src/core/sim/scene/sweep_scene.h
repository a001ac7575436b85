// The scene of the fingertip sweep, built around any layout.
//
// World: the object's edge is the line x = 0, z = top; it fills x > 0, z < top. The finger comes from x < 0 and moves
// along +x; its width axis (`distal` x `pad`) is +y. `distal` points forward and down, so that the tip leads over the
// edge and `pad`, behind and below it, faces the top.
#pragma once

#include "core/base/math.h"
#include "core/project/scenario.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/scene/scene_files.h"

namespace taxel {

struct SweepScene {
  SceneFiles files;         ///< scene.xml names the layout file
  std::string hosted_xml;   ///< the same, for a program that hands the compiled sensor over
  Pose X_start;             ///< of the mocap body and the finger's mesh-file frame, world
  dvec3 lowest_start_W{0};  ///< the finger's lowest point there
  dvec3 direction_W{1, 0, 0};
  double distance = 0;  ///< of the path [m]
};

/// Names of the sweep's geoms.
inline constexpr const char* kFingerGeom = "finger";
inline constexpr const char* kObjectGeom = "box";

/// Throws Error for scenario values out of range, or an object mesh that cannot be read.
SweepScene build_sweep_scene(const SensorModel& model, const SweepScenario& scenario);

}  // namespace taxel
