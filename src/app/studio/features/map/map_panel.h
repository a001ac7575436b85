// The panel that shows the taxels unrolled into a flat map, in the colours of their readings.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/map/map_state.h"

namespace taxel::ui {

void draw_map_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, MapState& map, bool& open);

}  // namespace taxel::ui
