// A path of waypoints for drawing.
#pragma once

#include <vector>

#include "core/base/math.h"

namespace taxel::ui {

/// Line and waypoints of the path of the finger's lowest point.
struct ShownPath {
  std::vector<dvec3> line_W, points_W;
  int selected = -1;  ///< index in points_W, or -1
  bool operator==(const ShownPath&) const = default;
};

}  // namespace taxel::ui
