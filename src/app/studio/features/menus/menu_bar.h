// The menus, made from the table of bindings.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_menu_bar(UiState& ui, const UiInput& input);
}  // namespace taxel::ui
