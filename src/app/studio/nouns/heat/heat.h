// The panel that draws readings as colours over taxels and time.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Readings over time as rows of colours.
extern const Feature kHeatMap;
/// Sets "heat": the rows, their place, and the cell under the pointer.
void dump_heat_map(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
