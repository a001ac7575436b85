// The strip of tools at the left edge of the 3-D view, one button for each tool of the mode.
#pragma once

namespace taxel::ui {

struct App;

/// Draws the strip over the view. Sets the width that the view's texts leave free for the strip.
void draw_tool_strip(App& app);

}  // namespace taxel::ui
