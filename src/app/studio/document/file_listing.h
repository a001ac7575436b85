// Folders for the file dialog.
#pragma once

#include <filesystem>

#include "app/studio/features/files/file_dialog_state.h"

namespace taxel::studio {
/// Shows `folder` in the dialog (empty: the working folder): folders first, then what can be opened, or what holds
/// points where these are asked for, by name. Where it cannot be listed, the dialog says why.
void list_folder(ui::FileDialog& dialog, const std::string& folder);

/// By its name: a picture; a table or a picture.
bool is_picture(const std::filesystem::path& file);
bool holds_points(const std::filesystem::path& file);
}  // namespace taxel::studio
