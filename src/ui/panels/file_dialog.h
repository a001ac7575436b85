// A small file dialog of our own: a list, a path, a filter. Folders are listed by the program.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {
void draw_file_dialog(UiState& ui);
}  // namespace taxel::ui
