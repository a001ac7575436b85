// The panel that explains a reading: diagnosis, samples, polygons, other numbers of samples, and where the force goes.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/explain/explain_state.h"

namespace taxel::ui {

void draw_explain_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open);

}  // namespace taxel::ui
