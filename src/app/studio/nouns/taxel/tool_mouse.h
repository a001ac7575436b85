// The mouse of the tools that edit the layout.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/scenario/path_state.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

/// Handles the view's mouse before the camera does. x, y: pointer in pixels of the view. Returns whether a tool
/// consumed it.
bool handle_tool_mouse(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate,
                       PathState& path, const SceneInput& scene, double x, double y, bool hovered);

}  // namespace taxel::ui
