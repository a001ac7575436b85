// What tools draw over the 3-D view: the taxel that a click would add, the box, what a gesture does, and why not.
#pragma once

#include <imgui.h>

#include <string>

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Returns how many lines of text it drew below the heading of the view.
int draw_tool_overlay(const UiState& ui, const UiInput& input);

/// A line of text below the heading of the view; lines go down.
void draw_view_line(const UiState& ui, ImDrawList& list, int row, const std::string& text, const ImVec4& color);
/// Where the line with this number begins [pixels of the window].
float view_line_top(const UiState& ui, int row);

}  // namespace taxel::ui
