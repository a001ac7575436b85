// The line at the bottom: rates, force, counts, messages.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {
void draw_status_line(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
