// Drawing over the 3-D view: pixels of points, and lines of text below the heading.
#pragma once

#include <imgui.h>

#include <string>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

/// Returns the pixel of the window at which a point of the scene is displayed.
[[nodiscard]] ImVec2 on_screen(const Viewer& viewer, const dvec3& p_W);
/// Draws the name of a standard or orthographic view, such as "Front, orthographic", in a row of texts of the view.
/// Returns the next free row.
int draw_view_name(const WindowUi& ui, const Viewer& viewer, ImDrawList& list, int row);
/// Draws a line of text below the heading of the view. Lines are numbered downward.
void draw_view_line(const WindowUi& ui, const ViewPlace& place, ImDrawList& list, int row, const std::string& text,
                    const ImVec4& color);
/// Returns the upper edge of the line with this number [pixels of the window].
[[nodiscard]] float view_line_top(const ViewPlace& place, int row);

}  // namespace taxel::ui
