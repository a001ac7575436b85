// The panel that shows the taxels unrolled into a flat map, in the colours of their readings.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The taxels as discs in a plane.
extern const Feature kTaxelMap;
/// Sets "map": the drawn discs.
void dump_taxel_map(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
