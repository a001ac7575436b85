#include "app/studio/nouns/files/file_listing.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "app/studio/frame/app.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/nouns/files/file_task.h"
#include "core/layout/formats/format_table.h"

namespace taxel::studio {

namespace fs = std::filesystem;

namespace {

bool can_be_opened(const fs::path& file) {
  try {
    document_kind(file);
    return !needs_mesh(file) || looks_like_foreign_layout(file);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

bool is_picture(const fs::path& file) {
  const std::string name = file.extension().string();
  return name == ".png" || name == ".PNG" || name == ".jpg" || name == ".JPG" || name == ".jpeg";
}

bool holds_points(const fs::path& file) {
  const std::string name = file.extension().string();
  return name == ".csv" || name == ".CSV" || name == ".txt" || name == ".tsv" || is_picture(file);
}

void list_folder(ui::FileDialog& dialog, const std::string& folder) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(folder.empty() ? fs::current_path() : fs::path(folder), error);
  fs::directory_iterator it(path, fs::directory_options::skip_permission_denied, error);
  dialog.error.clear();
  if (error) {
    dialog.error = path.string() + ": " + error.message();
    return;
  }
  dialog.folder = path.string();
  dialog.entries.clear();
  dialog.selected = -1;
  const auto wanted = dialog.task == ui::FileTask::read_points || dialog.task == ui::FileTask::import_recording
                          ? holds_points
                          : can_be_opened;
  for (const fs::directory_entry& entry : it) {
    const std::string name = entry.path().filename().string();
    std::error_code unreadable;
    const bool is_folder = entry.is_directory(unreadable);
    if (name.starts_with('.') || (!is_folder && !wanted(entry.path()))) continue;
    dialog.entries.push_back({name, is_folder});
  }
  std::sort(dialog.entries.begin(), dialog.entries.end(), [](const ui::FolderEntry& a, const ui::FolderEntry& b) {
    return std::tuple(!a.folder, a.name) < std::tuple(!b.folder, b.name);
  });
}

}  // namespace taxel::studio

namespace taxel::ui {

void carry_out(const ListFolder& command, App& app) {
  studio::list_folder(app.get<FileDialog>(), command.path);
}

}  // namespace taxel::ui
