// The fields of the selected taxels in the inspector: what is typed goes to all of them.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
/// Rows of a table of properties.
void draw_taxel_fields(UiState& ui, const Project& project);
}  // namespace taxel::ui
