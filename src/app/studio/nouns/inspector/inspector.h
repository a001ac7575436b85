// Values of the selected taxel, the sampling, the material, the scene and the sweep.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// All values of the layout and of the selection.
extern const Feature kInspector;
/// Sets "problems" and "region".
void dump_inspector(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
