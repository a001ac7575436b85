// The sensors of an open scene: the sensors that the scene declares, and layouts attached to its geoms.
#pragma once

#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scene/controls_state.h"

namespace taxel::ui {
/// Draws the section about sensors in the panel of controls.
void draw_attach_section(WindowUi& ui, Selection& selection, const RunView& run, ControlsState& controls);
}  // namespace taxel::ui
