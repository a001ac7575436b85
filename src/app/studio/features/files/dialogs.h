// What floats: help, the progress of a load, the card of an empty window.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_help(UiState& ui);
void draw_loading(UiState& ui, const UiInput& input);
/// Whether to save, before unsaved edits are left.
void draw_unsaved_question(UiState& ui, const UiInput& input);
/// Offers what a program that ended badly had kept.
void draw_recovery_card(UiState& ui);
/// In the middle of the view while nothing is open.
void draw_start_card(UiState& ui);
}  // namespace taxel::ui
