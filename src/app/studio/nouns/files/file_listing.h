// Lists folders for the file dialog.
#pragma once

#include <filesystem>
#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/files/file_dialog_state.h"

namespace taxel::ui {

struct ListFolder {
  std::string path;
};
void carry_out(const ListFolder& command, App& app);

}  // namespace taxel::ui

namespace taxel::studio {
/// Shows `folder` in the dialog, or the working folder if `folder` is empty: folders first, then files that can be
/// opened, or files that hold points if the dialog asks for points; both by name. The dialog says why if the folder
/// cannot be listed.
void list_folder(ui::FileDialog& dialog, const std::string& folder);

/// Returns whether the file is an image, by its extension.
bool is_picture(const std::filesystem::path& file);
/// Returns whether the file is a table or an image, by its extension.
bool holds_points(const std::filesystem::path& file);
}  // namespace taxel::studio
