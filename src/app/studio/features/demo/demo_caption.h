// The caption of the demo, which offers a newcomer the next steps.
#pragma once

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/demo/demo_state.h"

namespace taxel::ui {

/// Draws the caption at the lower edge of the view, until the mode changes or one of its buttons is pressed.
void draw_demo_caption(WindowUi& ui, const Viewer& viewer, DemoState& demo);

}  // namespace taxel::ui
