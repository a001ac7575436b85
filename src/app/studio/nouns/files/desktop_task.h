// The tasks of the file dialog as the desktop's dialog asks for them.
#pragma once

#include <optional>

#include "app/studio/nouns/files/file_dialog_state.h"
#include "core/base/os/file_chooser.h"

namespace taxel::ui {

struct DesktopTask {
  bool saves = false;     ///< asks for a file to write, otherwise for an existing file
  os::FileFilter filter;  ///< files of the task
};

/// Returns how the desktop's dialog asks for the file of a task, or nothing if only the window's dialog can ask: it has
/// fields for the size of a picture and for the format of a video.
[[nodiscard]] std::optional<DesktopTask> desktop_task(FileTask task);

/// Returns the question for the desktop's dialog: the title, the folder and the proposed name are those of `dialog`,
/// and the files of its task can be changed to all files. The task must be one that the desktop's dialog asks for.
[[nodiscard]] os::FileQuestion desktop_question(const FileDialog& dialog);

}  // namespace taxel::ui
