// What floats: help, the progress of a load, the card of an empty window.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {
void draw_help(UiState& ui);
void draw_loading(UiState& ui, const UiInput& input);
/// In the middle of the view while nothing is open.
void draw_start_card(UiState& ui);
}  // namespace taxel::ui
