// The small plots of the Explain panel.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// The reading by number of samples, beside the exact integral.
void draw_convergence(UiState& ui, const Explanation& explanation);
/// Area against pressure of all polygons; a click selects the nearest.
void draw_scatter(UiState& ui, const Explanation& explanation);

}  // namespace taxel::ui
