// The panel of data sets: episodes as a list, the curves of one, and its replay.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/data_set/data_set_state.h"

namespace taxel::ui {

/// At first the panel lies over the lower part of the view, so that a replay is visible above.
void draw_data_set_panel(WindowUi& ui, const ViewPlace& place, const Shown& shown, DataSetState& state, bool& open);

}  // namespace taxel::ui
