// What a hand can set in the running scene: layouts on its geoms, actuators, joints, keyframes, mocap bodies, equality
// constraints.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_controls_panel(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
