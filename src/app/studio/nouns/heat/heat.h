// The panel that draws readings as colours over taxels and time.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/heat/heat_state.h"

namespace taxel::ui {
/// Readings over time as rows of colours.
extern const Feature kHeatMap;
/// Sets "heat": the rows, their place, and the cell under the pointer.
void dump_heat_map(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
