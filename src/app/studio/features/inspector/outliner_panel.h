// What there is: the document's sensor, and the bodies of the running scene.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_outliner(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
