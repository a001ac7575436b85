// The tasks of the file dialog: their texts, the paths that the dialog forms, and its command for a file.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/files/file_dialog_state.h"

namespace taxel::ui {

struct TaskTexts {
  const char *title, *button;
  const char* extension;  ///< extension for a name without one; may be empty
};
[[nodiscard]] TaskTexts texts_of(FileTask task);
/// Returns the extension of the task's files; empty if any name is valid.
[[nodiscard]] const char* extension_of(FileTask task);

/// Returns the path of a file or folder in a folder.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& name);
/// Returns the folder that contains a folder; the root contains itself.
[[nodiscard]] std::string parent_of(const std::string& folder);

/// Returns the command of the dialog's task for a path. A name without an extension gets the extension of the task, but
/// a layout keeps every extension that names a format of layouts, and a plot keeps ".pdf". The command replaces an
/// existing file only if the dialog has asked about that file. `geoms` are the geoms that a layout is attached to.
[[nodiscard]] Command file_command(const FileDialog& dialog, const std::vector<std::string>& geoms,
                                   const std::string& path);

}  // namespace taxel::ui
