// The subtaxels of a taxel, in the inspector.
#pragma once

#include "app/studio/frame/window_ui.h"
#include "core/layout/layout.h"

namespace taxel::ui {

/// Draws the fields of the subtaxels, and the buttons Delete and Add, which make edits of the taxel.
void draw_subtaxels(WindowUi& ui, const Taxel& taxel);

}  // namespace taxel::ui
