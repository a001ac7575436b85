// Folders for the file dialog.
#pragma once

#include "ui/ui_state.h"

namespace taxel::studio {
/// Shows `folder` in the dialog (empty: the working folder): folders first, then what can be opened, by name.
/// Where it cannot be listed, the dialog says why.
void list_folder(ui::FileDialog& dialog, const std::string& folder);
}  // namespace taxel::studio
