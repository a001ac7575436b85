// The timeline of the latest steps: tracks with their values, markers of events, and the displayed step.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/timeline/timeline_state.h"

namespace taxel::ui {

void draw_timeline_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, Timeline& timeline, bool& open);

}  // namespace taxel::ui
