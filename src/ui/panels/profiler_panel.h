// Where the time of steps and of pictures goes.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {
void draw_profiler_panel(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
