// Beside the view's heading while the brush is in the hand: its radius, what is painted, and what to do with it.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {
void draw_brush_card(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool);
/// The ring that the brush would reach, on the skin; under the pointer.
void draw_brush_ring(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool);
}  // namespace taxel::ui
