// The tour of the window: five steps, each beside the part that it speaks of.
#pragma once

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/menus/tour_state.h"

namespace taxel::ui {
/// Back and Next, Enter for the next, Esc or Skip to end it; once ended it counts as seen.
void draw_tour(WindowUi& ui, TourState& tour);
}  // namespace taxel::ui
