// What is written over the 3-D view about the scene: what leads the camera, which marks are shown, and the info (F2).
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {
/// `row`: of the first line below the heading that is free.
void draw_scene_overlay(UiState& ui, const UiInput& input, int row);
}  // namespace taxel::ui
