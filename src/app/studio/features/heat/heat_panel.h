// The panel that draws readings as colours over taxels and time.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/heat/heat_state.h"

namespace taxel::ui {
void draw_heat_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, HeatState& heat, bool& open);
}  // namespace taxel::ui
