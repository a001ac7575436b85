// Where the time of steps and of pictures goes.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_profiler_panel(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
