// What is wrong with the layout that is edited, in the inspector, each with the button that mends it.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Of the selected taxels, or of all where none is selected; and the button that mends all of the layout.
void draw_problem_list(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
