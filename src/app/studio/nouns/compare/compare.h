// The panel that compares a run with a second layout: numbers, bars and curves of both, on one contact and one
// timeline.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The run with a second layout.
extern const Feature kCompare;
/// Sets "compare", which is null if nothing is compared.
void dump_compare(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
