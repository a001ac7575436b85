// The state of the measure tool: the clicked points and the point under the pointer.
#pragma once

#include <optional>
#include <vector>

#include "core/base/math.h"

namespace taxel::ui {

struct MeasurePoint {
  dvec3 at{0};               ///< position of the point, frame M
  std::optional<int> taxel;  ///< id of the taxel if the point is a taxel's centre
};

struct MeasureState {
  using PerDocument = MeasureState;  ///< another document resets all of it
  bool on = false;
  std::vector<MeasurePoint> points;   ///< clicked points, two at most
  std::optional<MeasurePoint> hover;  ///< place that the next click would add
};

}  // namespace taxel::ui
