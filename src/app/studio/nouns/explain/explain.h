// The panel that explains a reading: diagnosis, samples, polygons, other numbers of samples, and where the force goes.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Why a reading is as it is.
extern const Feature kExplain;
/// Sets "explain": what `taxel explain --json` prints, with step, selected polygon and ghost, or null.
void dump_explanation(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
