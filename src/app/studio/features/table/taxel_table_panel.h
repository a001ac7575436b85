// All taxels of the layout shown, with their readings.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_taxel_table(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
