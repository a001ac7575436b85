// What is written over the 3-D view about the scene: what leads the camera, which marks are shown, and the info (F2).
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
/// `row`: of the first line below the heading that is free. Returns the one that is free then.
int draw_scene_overlay(const UiState& ui, const UiInput& input, int row);
/// A window of its own: to be drawn after the view's, from that line on.
void draw_info_card(UiState& ui, const UiInput& input, int row);
}  // namespace taxel::ui
