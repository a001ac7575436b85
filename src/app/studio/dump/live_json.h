// What the views of the step shown say: tractions, the skin's colours, the map of taxels, other models.
#pragma once

#include <string>

#include "app/studio/app/ui_state.h"

namespace taxel::studio {

/// A JSON object with "tractions", "skin", "map" and "models".
std::string live_to_json(const ui::UiState& ui, const ui::UiInput& input);

}  // namespace taxel::studio
