// What lies under a pixel of the 3-D view, found on the processor: for hovering, clicking, centring.
#pragma once

#include <optional>

#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

/// What the pointer is on, nearest to the eye. A taxel within reach of the pointer wins over a contact polygon, that
/// over a sample, that over the skin and other bodies: as they are drawn.
struct Pick {
  int sensor = -1;                 ///< -1: not on a sensor
  int taxel = -1;                  ///< its centre is under the pointer; layout order
  int surface = -1, polygon = -1;  ///< of the sensor's contact surfaces
  double pressure = 0;             ///< there [Pa], when polygon >= 0
  int sample = -1;                 ///< nearest sample on the side that faces the eye, within reach
  int geom = -1;                   ///< of the scene: what the ray meets first, when no sensor's skin is nearer
  std::string geom_name;
  dvec3 position_W{0};  ///< the point under the pointer [m]
  double distance = 0;  ///< from the eye [m]
};

/// Nothing on the background. `reach`: how near the pointer must come to taxels and samples [pixel].
std::optional<Pick> pick(const SceneInput& input, const Camera& camera, double x, double y, int width, int height,
                         double reach = 8);

}  // namespace taxel::ui
