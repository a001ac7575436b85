// The tools that change taxels, with their lines and hints over the view.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The tools that change taxels.
extern const Feature kTaxelTools;
/// Sets "tool": the one in use.
void dump_tool(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
