// The contact of a sensor in a recorded step, computed again for another body in the place of the sensor's own.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/hydro/intersect.h"
#include "core/run/step.h"
#include "core/sensor/compare.h"

namespace taxel {

/// The poses of the bodies that a sensor can touch, in one step.
struct TouchedPoses {
  std::vector<Pose> X_WB;  ///< parallel to SimScene::touched of the sensor
  std::string unknown;     ///< why a body cannot be touched again, or empty
};

/// Returns why no contact of a scene can be computed again, or an empty text.
[[nodiscard]] std::string missing_touched(const SimScene& scene);

/// Returns the poses of the bodies that sensor number `sensor` can touch in a step.
[[nodiscard]] TouchedPoses touched_poses(const StepView& step, std::size_t sensor);

/// Computes the contact surface of a body with the sensor, exactly as Simulator::contact_at() does.
void intersect_touched(const HydroBody& self, const TouchedBody& other, const Pose& X_WM, const Pose& X_WB,
                       ContactSurface& out, IntersectWorkspace& workspace);

/// Returns the readings of a model whose body is at X_WM. The contact surfaces are those of the model's own body with
/// the touched bodies, which are at the poses `X_WB`.
[[nodiscard]] std::vector<double> read_own_contact(const SensorModel& model, const std::vector<TouchedBody>& touched,
                                                   const Pose& X_WM, std::span<const Pose> X_WB);

/// Returns read_own_contact() of a model in the place of sensor number `sensor` of a step, with `touched` in the place
/// of the bodies that the sensor can touch. ModelReading::missing says which body cannot be touched again.
[[nodiscard]] ModelReading read_in_place(ReadingModel as, const SensorModel& model,
                                         const std::vector<TouchedBody>& touched, const StepView& step,
                                         std::size_t sensor);

}  // namespace taxel
