// The pressure bars as they were drawn in the last frame.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// The image of one bar as numbers.
struct BarShown {
  int sensor = 0;  ///< index of the sensor in the simulation
  int taxel_id = 0;
  double value = 0;        ///< reading, in SI units
  double error = 0;        ///< error bar of the reading, in SI units; 0 if none is drawn
  double height = 0;       ///< [pixels]
  Rect rect;               ///< the filled part
  double top = 0;          ///< reading at the top of the axis, in SI units
  double axis_height = 0;  ///< height of the whole axis [pixels]
  glm::vec3 color{0};      ///< colour of the filled part, sRGB
  bool outlined = false;   ///< whether an outline sets the bar off from the background
  bool over = false;       ///< whether the value is above a fixed range
};

using BarsShown = std::vector<BarShown>;

}  // namespace taxel::ui
