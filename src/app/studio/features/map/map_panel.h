// The taxels unrolled into a flat map, in the colours of their readings.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_map_panel(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
