// The panel that draws the readings of the displayed step as bars.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The bar chart of all readings.
extern const Feature kBars;
/// Sets "bars": the drawn bars.
void dump_bars(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
