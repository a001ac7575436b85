// The readings of this very step as bars.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_bars_panel(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
