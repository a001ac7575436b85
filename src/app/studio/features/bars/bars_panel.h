// The panel that draws the readings of the displayed step as bars.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/bars/bars_state.h"
#include "app/studio/features/bars/error_bars_state.h"

namespace taxel::ui {
void draw_bars_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, BarsShown& bars, ErrorBarsState& errors,
                     bool& open);
}  // namespace taxel::ui
