// Functions that open the file dialog.
#pragma once

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"

namespace taxel::ui {

/// Returns whether the user wants the desktop's dialog and there is one.
[[nodiscard]] bool uses_desktop(const FileDialog& dialog);
/// Returns the reason why the desktop's dialog cannot be used; empty if it can.
[[nodiscard]] const char* why_no_desktop(const FileDialog& dialog);

/// Opens the window's file dialog with empty fields.
void begin_own_dialog(FileDialog& dialog, FileTask task);
/// Does the same, or requests the desktop's dialog if it is used and can ask for the task's file.
void begin_dialog(FileDialog& dialog, FileTask task);
/// Opens the dialog for the file to open, and lists its folder.
void open_dialog(WindowUi& ui, FileDialog& dialog);

}  // namespace taxel::ui
