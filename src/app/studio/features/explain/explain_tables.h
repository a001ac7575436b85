// The tables of the Explain panel.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/explain/explain_state.h"

namespace taxel::ui {

/// The polygons that serve the taxel, and the one that is selected; a click selects one.
void draw_polygons(WindowUi& ui, ExplainState& explain, const Explanation& explanation);
/// The samples that hit, now or before.
void draw_samples(WindowUi& ui, const Explanation& explanation);

}  // namespace taxel::ui
