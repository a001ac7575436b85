// One simulation step: its scene, poses, sensors and facts. Plain values, free of MuJoCo.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/run/scene.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// All values of a step except those of its sensors.
struct StepState {
  std::shared_ptr<const SimScene> scene;
  std::uint64_t step = 0;        ///< number of the step in its run
  double time = 0;               ///< time of the evaluated state [s]
  double travel = 0;             ///< distance of the mocap body from its start, or along its path [m]
  bool finished = false;         ///< the end of the scenario is reached
  std::vector<Pose> geom_poses;  ///< X_WG, parallel to scene->geoms
  std::vector<ConstraintPoints> constraint_points;
  MarkPoses mark_poses;  ///< poses of scene->marks
  StepFacts facts;
};

/// A step with all its sensors.
struct Step : StepState {
  std::vector<SensorStep> sensors;  ///< parallel to scene->sensors
};
using StepPtr = std::shared_ptr<const Step>;

}  // namespace taxel
