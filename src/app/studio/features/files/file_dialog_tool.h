// Functions that open the file dialog.
#pragma once

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/file_dialog_state.h"

namespace taxel::ui {

/// Opens the file dialog with empty fields.
void begin_dialog(FileDialog& dialog, FileTask task);
/// Opens the dialog for the file to open, and lists its folder.
void open_dialog(WindowUi& ui, FileDialog& dialog);

}  // namespace taxel::ui
