// The command of the file dialog for a file.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/files/file_dialog_state.h"

namespace taxel::ui {

/// Returns the command of the dialog's task for a path. A name without an extension gets the extension of the task, but
/// a layout keeps every extension that names a format of layouts, and a plot keeps ".pdf". The command replaces an
/// existing file only if the dialog has asked about that file. `geoms` are the geoms that a layout is attached to.
[[nodiscard]] Command file_command(const FileDialog& dialog, const std::vector<std::string>& geoms,
                                   const std::string& path);

}  // namespace taxel::ui
