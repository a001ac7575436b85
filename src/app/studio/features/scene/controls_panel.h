// The panel of settings of the running scene: layouts on geoms, actuators, joints, keyframes, mocap bodies and equality
// constraints.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/scene/controls_state.h"

namespace taxel::ui {
void draw_controls_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ControlsState& controls, bool& open);
}  // namespace taxel::ui
