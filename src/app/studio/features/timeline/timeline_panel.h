// The latest steps on a line: what each lane says of them, where something happened, and which one is shown.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_timeline_panel(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
