// A path of way points as it is drawn.
#pragma once

#include <vector>

#include "core/base/math.h"

namespace taxel::ui {

/// Its line, and its way points: where the finger's lowest point is led.
struct ShownPath {
  std::vector<dvec3> line_W, points_W;
  int selected = -1;  ///< index in points_W, or -1
  bool operator==(const ShownPath&) const = default;
};

}  // namespace taxel::ui
