// Drawings of the tools over the 3-D view: the taxel that a click would add, the box, and the value or problem of a
// gesture.
#pragma once

namespace taxel::ui {

struct App;

/// Draws the overlay. Returns the number of lines of text that were drawn below the heading of the view.
int draw_tool_overlay(const App& app);

}  // namespace taxel::ui
