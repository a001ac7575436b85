// Below the menus: mode, transport, speed, what is drawn.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_toolbar(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
