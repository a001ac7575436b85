// What the measure holds on to.
#pragma once

#include <optional>
#include <vector>

#include "core/base/math.h"

namespace taxel::ui {

struct MeasurePoint {
  dvec3 at{0};               ///< frame M
  std::optional<int> taxel;  ///< id of the taxel whose centre it is
};

struct MeasureState {
  using PerDocument = MeasureState;  ///< another document resets all of it
  bool on = false;
  std::vector<MeasurePoint> points;   ///< clicked; two at most
  std::optional<MeasurePoint> hover;  ///< where the next one would be
};

}  // namespace taxel::ui
