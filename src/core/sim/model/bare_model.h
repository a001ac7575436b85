// A soft geom without taxels as viewers and recordings know sensors.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// The model of a sensor without taxels, samples and rays with this body; `surface` is what is drawn of it.
SensorModelPtr bare_model(const std::string& name, const TriMeshPtr& surface, const HydroBodyPtr& body);

/// The same of a geom, in the geom's frame.
SensorModelPtr bare_model(const mjModel& m, int geom, const HydroBodyPtr& body);

}  // namespace taxel
