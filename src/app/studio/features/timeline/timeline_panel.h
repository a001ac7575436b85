// The timeline of the latest steps at the bottom of the window: one line with the displayed step and markers of events,
// which unfolds to tracks with their values and to the conditions that pause a run.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/timeline/timeline_state.h"

namespace taxel::ui {

/// Draws the timeline over the whole width, above the bars that are at the bottom already. `rows` is the number of rows
/// that its buttons needed in the previous frame.
void draw_timeline(WindowUi& ui, const Viewer& viewer, const Shown& shown, Timeline& timeline, int& rows, bool open);

}  // namespace taxel::ui
