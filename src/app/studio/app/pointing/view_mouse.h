// The mouse in the 3-D view: tools, then camera moves and selections.
#pragma once

#include "app/studio/app/app.h"

namespace taxel::ui {

/// Reads ImGui's mouse over the view's item (the last one): orbit, pan, zoom, centre, select, hover.
void handle_view_mouse(App& app);

}  // namespace taxel::ui
