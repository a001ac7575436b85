// The fields of the selected taxels in the inspector: what is typed goes to all of them.
#pragma once

#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {
/// Rows of a table of properties.
void draw_taxel_fields(WindowUi& ui, Selection& selection, const Project& project);
}  // namespace taxel::ui
