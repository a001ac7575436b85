// The inspector's part about how the finger is led.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Kind, its values, its way points, and the button that runs it. Each change is an edit of the document.
void draw_scenario_section(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
