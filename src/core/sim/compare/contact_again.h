// The contact of a sensor in a recorded step, computed again for another body in the place of the sensor's own.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/hydro/intersect.h"
#include "core/run/scene.h"
#include "core/sensor/sensor_step.h"

namespace taxel {

/// The poses of the bodies that a sensor can touch, in one step.
struct TouchedPoses {
  std::vector<Pose> X_WB;  ///< parallel to SimScene::touched of the sensor
  std::string unknown;     ///< why a body cannot be touched again, or empty
};

/// Returns the poses of the bodies that sensor number `sensor` can touch. `sensors` has all sensors of the scene,
/// `X_WG` the poses of all its geoms.
[[nodiscard]] TouchedPoses touched_poses(const SimScene& scene, std::size_t sensor, std::span<const SensorStep> sensors,
                                         std::span<const Pose> X_WG);

/// Computes the contact surface of a body with the sensor, exactly as Simulator::contact_at() does.
void intersect_touched(const HydroBody& self, const TouchedBody& other, const Pose& X_WM, const Pose& X_WB,
                       ContactSurface& out, IntersectWorkspace& workspace);

/// Returns the readings of a model whose body is at X_WM. The contact surfaces are those of the model's own body with
/// the touched bodies, which are at the poses `X_WB`.
[[nodiscard]] std::vector<double> read_own_contact(const SensorModel& model, const std::vector<TouchedBody>& touched,
                                                   const Pose& X_WM, std::span<const Pose> X_WB);

}  // namespace taxel
