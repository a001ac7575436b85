// The middle of the contact, which cameras follow.
#pragma once

#include <optional>

#include "core/run/frame.h"

namespace taxel::ui {

/// Returns the mean of the contact surfaces' centroids, weighted with their areas, of all sensors of a frame [m],
/// world. Empty without contact.
[[nodiscard]] inline std::optional<dvec3> contact_center(const SimFrame& frame) {
  dvec3 moment_W{0};
  double area = 0;
  for (const SensorStep& sensor : frame.sensors) {
    for (const ContactSurface& surface : sensor.surfaces) {
      for (const ContactPolygon& polygon : surface.polygons) {
        moment_W += polygon.area * (sensor.X_WM * polygon.centroid);
        area += polygon.area;
      }
    }
  }
  if (!(area > 0)) return std::nullopt;
  return moment_W / area;
}

}  // namespace taxel::ui
