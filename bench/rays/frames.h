// Recorded contact: the fingertip pressed, slid, rolled and wedged into a groove, frame by frame.
#pragma once

#include <string>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/sensor_model.h"

namespace taxel::bench {

/// Objects that the finger touches: one flat box, or spheres of many triangles, which cut many more polygons.
enum class Object { box, sphere };

struct Path {
  std::string name;
  std::vector<std::vector<ContactSurface>> frames;  ///< frame M of the sensor, one surface per object
  [[nodiscard]] double mean_polygons() const;
};

std::vector<Path> record_paths(const SensorModel& sensor, Object object);

/// A flat array facing up, pressed and slid on.
std::vector<Path> record_flat_paths(const SensorModel& sensor, Object object);

/// The project's fingertip with its 12 taxels, at a density that gives about this number of rays.
SensorModelPtr fingertip_with_rays(int rays);

/// A layout of the presets.
SensorModelPtr preset_sensor(const std::string& name);

}  // namespace taxel::bench
