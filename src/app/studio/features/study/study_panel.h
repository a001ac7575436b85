// Parameter studies: the scenario run with several values of one or two parameters, as small multiples.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_study_panel(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
