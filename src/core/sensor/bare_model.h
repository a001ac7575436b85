// The model of a body without taxels, for viewers and recordings, which show sensors.
#pragma once

#include <string>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns the model of a sensor with this body but without taxels, samples and rays; `surface` is drawn for it.
/// Without a body (null), the model is only for viewing: it has no contact.
SensorModelPtr bare_model(const std::string& name, const TriMeshPtr& surface, const HydroBodyPtr& body);

}  // namespace taxel
