// The tables of the Explain panel.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// The polygons that serve the taxel, and the one that is selected; a click selects one.
void draw_polygons(UiState& ui, const Explanation& explanation);
/// The samples that hit, now or before.
void draw_samples(UiState& ui, const Explanation& explanation);

}  // namespace taxel::ui
