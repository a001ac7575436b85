// A popup next to the view's heading while the brush is active: the radius, the painted region and its commands.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {
void draw_brush_card(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool);
/// Draws the outline of the brush on the skin under the pointer.
void draw_brush_ring(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool);
}  // namespace taxel::ui
