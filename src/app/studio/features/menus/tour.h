// The tour of the window: five steps, each displayed next to the part that the step explains.
#pragma once

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/menus/tour_state.h"

namespace taxel::ui {
/// Draws the present step with its buttons. Back and Next change the step, Enter is Next, and Esc or Skip end the tour.
/// A tour that has ended is recorded as seen.
void draw_tour(WindowUi& ui, TourState& tour);
}  // namespace taxel::ui
