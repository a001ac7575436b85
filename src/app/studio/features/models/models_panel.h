// The panel that compares readings of one contact by several models: a table of the displayed step, and curves over the
// recorded steps.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/models/models_state.h"

namespace taxel::ui {

void draw_models_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ModelsState& models, bool& open);

}  // namespace taxel::ui
