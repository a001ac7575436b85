// Model of a layout for display, even if the layout can be viewed but not simulated.
#pragma once

#include <functional>
#include <string>

#include "core/sensor/sensor_model.h"

namespace taxel::studio {

struct ShownModel {
  SensorModelPtr model;
  std::string problem;  ///< reason why the layout cannot be simulated, or empty
};

/// Compiles a layout on its mesh as loaded by `compile`. A soft layout whose mesh cannot be repaired, by the layout's
/// own recipe or at all, is compiled as a rigid layout on the mesh as loaded, for viewing and for placing taxels. A
/// soft layout without taxels on a mesh of more than kManySkinTriangles has no body. Throws as `compile` does.
ShownModel shown_model(const Layout& layout, const TriMeshPtr& mesh,
                       const std::function<SensorModelPtr(const Layout&)>& compile);

}  // namespace taxel::studio
