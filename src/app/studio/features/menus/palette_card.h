// The command palette (Ctrl+K): type part of a name, choose with the arrows, run with Enter.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_palette(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
