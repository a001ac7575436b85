// Picking: the object under a pixel of the 3-D view, found on the processor, for hovering, clicking and centring.
#pragma once

#include <optional>

#include "ui/scene/pick/camera.h"
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

}  // namespace taxel::ui
