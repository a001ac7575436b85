// A popup next to the view's heading while the brush is active: the radius, the painted region and its commands.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {
/// Draws the outline of the brush on the skin under the pointer.
void draw_brush_ring(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool);

/// The settings of the brush, over the view.
extern const Feature kBrush;

}  // namespace taxel::ui
