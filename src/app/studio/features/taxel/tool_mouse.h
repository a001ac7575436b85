// The mouse of the tools that edit the layout.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/scenario/path_state.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

/// Handles the view's mouse before the camera does. x, y: pointer in pixels of the view. Returns whether a tool
/// consumed it.
bool handle_tool_mouse(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate,
                       PathState& path, const SceneInput& scene, double x, double y, bool hovered);

}  // namespace taxel::ui
