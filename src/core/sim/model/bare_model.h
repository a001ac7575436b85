// A soft geom without taxels as viewers and recordings know sensors.
#pragma once

#include <mujoco/mujoco.h>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// The model of a sensor without taxels, samples and rays whose body is that of a geom, in the geom's frame; its mesh
/// is the drawn surface of the geom.
SensorModelPtr bare_model(const mjModel& m, int geom, const HydroBodyPtr& body);

}  // namespace taxel
