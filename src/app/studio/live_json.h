// What the views of the step shown say: tractions, the skin's colours, the map of taxels.
#pragma once

#include <string>

#include "ui/ui_state.h"

namespace taxel::studio {

/// A JSON object with "tractions", "skin" and "map".
std::string live_to_json(const ui::UiState& ui, const ui::UiInput& input);

}  // namespace taxel::studio
