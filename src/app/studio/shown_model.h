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

/// Compiles a layout by `compile`. One that is soft on a mesh that is not closed, which no body can be made of, is
/// compiled as a rigid one: to look at, and to place taxels on.
ShownModel shown_model(const Layout& layout, const TriMesh& mesh,
                       const std::function<SensorModelPtr(const Layout&)>& compile);

}  // namespace taxel::studio
