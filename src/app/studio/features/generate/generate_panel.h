// Makes many taxels at once: a pattern, its parameters, and a live preview in the view until it is added.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_generate_panel(UiState& ui, const UiInput& input);
/// Where the pattern lies, in the view: its centre, the direction of rows and the one across.
void draw_pattern_frame(const UiState& ui, const UiInput& input);
}  // namespace taxel::ui
