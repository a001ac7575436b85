// The tour of the window: five steps, each beside the part that it speaks of.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
/// Back and Next, Enter for the next, Esc or Skip to end it; once ended it counts as seen.
void draw_tour(UiState& ui);
}  // namespace taxel::ui
