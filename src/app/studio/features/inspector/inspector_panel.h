// Values of the selected taxel, the sampling, the material, the scene and the sweep.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_inspector(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
