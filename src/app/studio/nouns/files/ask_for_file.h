// Asks for a file by the file dialog.
#pragma once

#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/files/file_task.h"

namespace taxel::studio {
/// Opens the file dialog for a task, with a name after the document's. A problem is displayed by the window's own
/// dialog.
void ask_for_file(ui::App& app, ui::FileTask task, const std::string& problem);
}  // namespace taxel::studio
