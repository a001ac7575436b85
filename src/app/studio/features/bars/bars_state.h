// The pressure bars as they were drawn in the last frame.
#pragma once

#include <vector>

#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// The image of one bar as numbers.
struct BarShown {
  int taxel_id = 0;
  double value = 0;        ///< [Pa]
  double height = 0;       ///< [pixels]
  Rect rect;               ///< the filled part
  double top = 0;          ///< pressure at the top of the axis [Pa]
  double axis_height = 0;  ///< height of the whole axis [pixels]
};

using BarsShown = std::vector<BarShown>;

}  // namespace taxel::ui
