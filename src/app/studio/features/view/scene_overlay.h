// What is written over the 3-D view about the scene: what leads the camera, which marks are shown, and the info (F2).
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/view/view_state.h"

namespace taxel::ui {
/// `row`: of the first line below the heading that is free. Returns the one that is free then.
int draw_scene_overlay(const WindowUi& ui, const Viewer& viewer, const RunView& run, const FollowState& follow,
                       const ViewShown& view, int row);
/// A window of its own: to be drawn after the view's, from that line on.
void draw_info_card(WindowUi& ui, const Viewer& viewer, const RunView& run, const PanelsShown& panels, int row);
}  // namespace taxel::ui
