// One contact as other models read it: a table of the step shown, and curves over the recorded steps.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_models_panel(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
