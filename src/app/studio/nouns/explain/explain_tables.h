// The tables of the Explain panel.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"

namespace taxel::ui {

/// Draws the table of the polygons that contribute to the taxel, and the selected polygon. A click selects a polygon.
void draw_polygons(WindowUi& ui, ExplainState& explain, const Explanation& explanation);
/// Draws the table of the samples that hit a polygon, in the explained step or the previous step.
void draw_samples(WindowUi& ui, const Explanation& explanation);

}  // namespace taxel::ui
