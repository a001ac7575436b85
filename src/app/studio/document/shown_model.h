// What the window shows of a layout: its model, also where the layout cannot be used as it is but can be looked at.
#pragma once

#include <functional>
#include <string>

#include "core/sensor/sensor_model.h"

namespace taxel::studio {

struct ShownModel {
  SensorModelPtr model;
  std::string problem;  ///< why the layout cannot be simulated; empty: it can
};

/// Compiles a layout by `compile`. A soft layout whose mesh cannot be repaired, by the layout's own recipe or at all,
/// is compiled as a rigid one on the mesh as loaded: to look at, and to place taxels on.
ShownModel shown_model(const Layout& layout, const std::function<SensorModelPtr(const Layout&)>& compile);

}  // namespace taxel::studio
