// The state of the taxel map: the unrolled layout and the drawn discs.
#pragma once

#include <vector>

#include "core/layout/field/flat_map.h"
#include "core/sensor/sensor_model.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// A disc as it was drawn in the last frame.
struct MapDisc {
  int sensor = 0;  ///< index of the sensor in the simulation
  int taxel_id = 0;
  double value = 0;                 ///< reading in SI units, or 0 without a reading
  double x = 0, y = 0, radius = 0;  ///< middle and radius [pixels]
};

/// The unrolled layout of one sensor.
struct SensorMap {
  SensorModelPtr model;  ///< model that `map` was unrolled from
  FlatMap map;
};

struct MapState {
  std::vector<SensorMap> maps;  ///< one per displayed sensor
  bool unrolled = false;        ///< whether the map of the selected sensor is unrolled
  std::vector<MapDisc> discs;   ///< one disc per taxel; empty if the panel is closed
};

}  // namespace taxel::ui
