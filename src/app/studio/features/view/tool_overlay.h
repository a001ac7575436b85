// Drawings of tools over the 3-D view: the taxel that a click would add, the box, and the value or problem of a
// gesture.
#pragma once

#include <imgui.h>

#include <string>

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/measure/measure_state.h"
#include "app/studio/features/mesh/mesh_state.h"
#include "app/studio/features/probe/probe_state.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

/// Draws the overlay. Returns the number of lines of text that were drawn below the heading of the view.
int draw_tool_overlay(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool,
                      const GenerateState& generate, const ProbeState& probe, const MeasureState& measure,
                      const MeshState& mesh);

/// Draws a line of text below the heading of the view. Lines are numbered downward.
void draw_view_line(const WindowUi& ui, const ViewPlace& place, ImDrawList& list, int row, const std::string& text,
                    const ImVec4& color);
/// Returns the upper edge of the line with this number [pixels of the window].
float view_line_top(const ViewPlace& place, int row);

}  // namespace taxel::ui
