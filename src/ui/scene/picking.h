// Picking: the object under a pixel of the 3-D view, found on the processor, for hovering, clicking and centring; and
// the taxels that use a sample.
#pragma once

#include <optional>
#include <vector>

#include "core/sensor/sensor_model.h"
#include "ui/scene/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// The object under the pointer, nearest to the eye. A taxel within reach of the pointer has priority over a contact
/// polygon, a polygon over a sample, a sample over the skin and other bodies, in the order in which they are drawn.
struct Pick {
  int sensor = -1;                 ///< index of the sensor, or -1
  int taxel = -1;                  ///< taxel whose centre is under the pointer, in layout order, or -1
  int surface = -1, polygon = -1;  ///< indices among the sensor's contact surfaces
  double pressure = 0;             ///< pressure at the point [Pa], if polygon >= 0
  int sample = -1;                 ///< nearest sample within reach, on the side that faces the eye, or -1
  int geom = -1;                   ///< first geom of the scene on the ray if no sensor's skin is nearer
  std::string geom_name;
  dvec3 position_W{0};  ///< point under the pointer [m]
  double distance = 0;  ///< distance from the eye [m]
};

/// Returns the object at a pixel, or nothing on the background. `reach` is the largest distance of the pointer from a
/// taxel or sample [pixel].
std::optional<Pick> pick(const SceneInput& input, const Camera& camera, double x, double y, int width, int height,
                         double reach = 8);

/// Use of a sample by its taxels.
struct SampleUse {
  int taxel = 0;         ///< index in layout order
  double distance = 0;   ///< distance by the layout's metric [m]
  double angle_deg = 0;  ///< angle of its normal and that of the taxel or nearest subtaxel
  double weight = 0;     ///< weight in the reading [m^2]
};

/// Returns the uses of a sample, the nearest taxel first; empty if no taxel uses the sample.
std::vector<SampleUse> uses_of_sample(const SensorModel& model, int sample);

}  // namespace taxel::ui
