// Texts over the 3-D view about the scene: the followed camera or body, the displayed glyphs, and the information (F2).
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/view/view_state.h"

namespace taxel::ui {
/// Draws the texts. `row` is the first free line below the heading. Returns the next free line.
int draw_scene_overlay(const WindowUi& ui, const Viewer& viewer, const RunView& run, const FollowState& follow,
                       const ViewShown& view, int row);
/// Draws the information in a separate window, from line `row` on. Must be called after the view's window is drawn.
void draw_info_card(WindowUi& ui, const Viewer& viewer, const RunView& run, const PanelsShown& panels, int row);
}  // namespace taxel::ui
