// The pointer over the 3-D view, which goes through the tools of all features.
#pragma once

namespace taxel::ui {

struct App;

/// Reads the pointer over the view's item and gives it to the tools in the order of the rows, until one consumes it.
void handle_view_mouse(App& app);

}  // namespace taxel::ui
