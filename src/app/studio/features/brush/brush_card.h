// Beside the view's heading while the brush is in the hand: its radius, what is painted, and what to do with it.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_brush_card(UiState& ui, const UiInput& input);
/// The ring that the brush would reach, on the skin; under the pointer.
void draw_brush_ring(const UiState& ui, const UiInput& input);
}  // namespace taxel::ui
