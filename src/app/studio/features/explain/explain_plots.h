// The small plots of the Explain panel.
#pragma once

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/explain/explain_state.h"

namespace taxel::ui {

/// The reading by number of samples, beside the exact integral.
void draw_convergence(WindowUi& ui, const Explanation& explanation);
/// Area against pressure of all polygons; a click selects the nearest.
void draw_scatter(WindowUi& ui, ExplainState& explain, const Explanation& explanation);

}  // namespace taxel::ui
