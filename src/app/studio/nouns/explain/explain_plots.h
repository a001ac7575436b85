// The small plots of the Explain panel.
#pragma once

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"

namespace taxel::ui {

/// Draws the reading against the number of samples, together with the exact integral.
void draw_convergence(WindowUi& ui, const Explanation& explanation);
/// Draws the area against the pressure of all polygons. A click selects the nearest polygon.
void draw_scatter(WindowUi& ui, ExplainState& explain, const Explanation& explanation);

}  // namespace taxel::ui
