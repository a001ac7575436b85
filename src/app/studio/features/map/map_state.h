// What the map of taxels keeps, and what it drew.
#pragma once

#include <vector>

#include "core/layout/field/flat_map.h"
#include "core/sensor/sensor_model.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// A disc as it was drawn in the last frame.
struct MapDisc {
  int taxel_id = 0;
  double value = 0;                 ///< reading, in SI; 0 where nothing is read
  double x = 0, y = 0, radius = 0;  ///< [pixel]
};

struct MapState {
  SensorModelPtr model;  ///< that `map` is of
  FlatMap map;
  std::vector<MapDisc> discs;  ///< by taxel; empty: the panel is closed
};

}  // namespace taxel::ui
