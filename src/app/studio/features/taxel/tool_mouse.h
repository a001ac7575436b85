// The mouse of the tools that edit the layout.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Handles the view's mouse before the camera does. x, y: pointer in pixels of the view. Returns whether a tool
/// consumed it.
bool handle_tool_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered);

}  // namespace taxel::ui
