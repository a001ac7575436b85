// The state of the taxel map: the unrolled layout and the drawn discs.
#pragma once

#include <vector>

#include "core/layout/field/flat_map.h"
#include "core/sensor/sensor_model.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// A disc as it was drawn in the last frame.
struct MapDisc {
  int taxel_id = 0;
  double value = 0;                 ///< reading in SI units, or 0 without a reading
  double x = 0, y = 0, radius = 0;  ///< middle and radius [pixels]
};

struct MapState {
  SensorModelPtr model;  ///< model that `map` was unrolled from
  FlatMap map;
  std::vector<MapDisc> discs;  ///< one disc per taxel; empty if the panel is closed
};

}  // namespace taxel::ui
