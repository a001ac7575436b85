// A small file dialog of our own: a list, a path, a filter. Folders are listed by the program.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_file_dialog(UiState& ui);
/// What names of files for this task end with; empty: anything.
const char* extension_of(FileTask task);
}  // namespace taxel::ui
