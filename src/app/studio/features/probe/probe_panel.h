// What the probe is, and what it feels: a small window over the 3-D view.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_probe_panel(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
