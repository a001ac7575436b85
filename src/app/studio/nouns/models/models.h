// The panel that compares readings of one contact by several models: a table of the displayed step, and curves over the
// recorded steps.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The readings of other models for the displayed contact.
extern const Feature kModels;
/// Sets "models": the readings at the displayed step, and their comparison over all steps that were read.
void dump_models(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
