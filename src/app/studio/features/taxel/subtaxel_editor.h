// The subtaxels of a taxel, in the inspector.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Fields, Delete and Add, as edits of the taxel.
void draw_subtaxels(UiState& ui, const Taxel& taxel);

}  // namespace taxel::ui
