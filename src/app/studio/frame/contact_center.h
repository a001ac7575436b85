// The middle of the contact, which cameras follow.
#pragma once

#include <optional>

#include "core/hydro/traction.h"
#include "core/run/frame.h"

namespace taxel::ui {

/// Returns the centre of pressure of all sensors of a frame [m], world. Empty without contact.
[[nodiscard]] inline std::optional<dvec3> contact_center(const SimFrame& frame) {
  CenterOfPressure center_W;
  for (const SensorStep& sensor : frame.sensors)
    for (const ContactSurface& surface : sensor.surfaces) center_W.add(surface, sensor.X_WM);
  return center_W.value();
}

}  // namespace taxel::ui
