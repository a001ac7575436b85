// One simulation step: its scene, poses, sensors and facts. Plain values, free of MuJoCo.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/run/scene.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// Identifies a step of a session: equal steps were read by the same models of the same scene.
struct StepId {
  std::uint64_t run = 0;   ///< number of runs that were started before, SimFrame::runs
  std::uint64_t step = 0;  ///< number of the step in its run
  std::uint64_t model_edition = 0;
  bool operator==(const StepId&) const = default;
};

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
