// The caption of the demo, which offers a newcomer the next steps.
#pragma once

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/demo/demo_state.h"

namespace taxel::ui {

/// Draws the caption at the lower edge of the view, until the mode changes or one of its buttons is pressed.
void draw_demo_caption(WindowUi& ui, const Viewer& viewer, DemoState& demo);

}  // namespace taxel::ui
