// The steps of the document's history as a list: a click undoes or redoes up to a step.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {
void draw_history_panel(WindowUi& ui, const Editing& editing, bool& open);
}  // namespace taxel::ui
