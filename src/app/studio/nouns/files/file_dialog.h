// The file dialog: the rows of its tasks, its begin, the listed folder, and its questions to the desktop's own dialog.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/command.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "core/base/os/file_chooser.h"

namespace taxel::ui {

/// A task as a row: its texts, and its files as the desktop's dialog shows them.
struct FileTaskRow {
  FileTask task;
  const char *title, *button;
  const char* extension;                          ///< extension for a name without one; empty if any name is valid
  bool saves;                                     ///< asks for a file to write, otherwise for an existing file
  const char* files;                              ///< name of the files, or null if the window must ask
  std::vector<std::string_view> (*extensions)();  ///< returns those of the files, or null
};
[[nodiscard]] const FileTaskRow& row_of(FileTask task);

/// Returns the path of a file or folder in a folder.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& name);
/// Returns the folder that contains a folder; the root contains itself.
[[nodiscard]] std::string parent_of(const std::string& folder);

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

/// Lists a folder for the dialog.
struct ListFolder {
  std::string path;
};
void carry_out(const ListFolder& command, App& app);

/// Looks up the folder of the typed path, for its completion.
struct ListTyped {
  std::string path;  ///< absolute path
};
void carry_out(const ListTyped& command, App& app);

/// Returns the absolute path of a typed text: a relative one starts at the listed folder, and "~/" at the first place,
/// the home folder.
[[nodiscard]] std::string typed_path(const FileDialog& dialog, const std::string& text);

/// Returns what Tab adds to a typed text: the rest of the longest beginning that all entries with this beginning share,
/// and a slash after the only folder. Empty if nothing can be added.
[[nodiscard]] std::string completion(const FileDialog& dialog, const std::string& text);

/// Sorts entries, folders first. Entries that are equal in the column are in the order of their names.
void sort_entries(std::vector<FolderEntry>& entries, EntryOrder order);

/// A task as the desktop's dialog asks for its file.
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

namespace taxel::studio {

/// Shows `folder` in the dialog, or the working folder if `folder` is empty: folders first, then files that can be
/// opened, or files that hold points if the dialog asks for points; in the dialog's order. The dialog says why if the
/// folder cannot be listed.
void list_folder(ui::FileDialog& dialog, const std::string& folder);

/// Returns why a file cannot be opened, by its name and its beginning: the kinds of files that can be, and a remedy.
/// Empty if it may be opened.
[[nodiscard]] std::string why_not_opened(const std::filesystem::path& file);

/// Sets the places of the dialog: the home folder, the working folder, and the folder of the open file.
void find_places(ui::FileDialog& dialog, const std::string& open_file);

/// Returns whether the file is an image, by its extension.
bool is_picture(const std::filesystem::path& file);
/// Returns whether the file is a table or an image, by its extension.
bool holds_points(const std::filesystem::path& file);

/// Opens the file dialog for a task, with a name after the document's. A problem is displayed by the window's own
/// dialog.
void ask_for_file(ui::App& app, ui::FileTask task, const std::string& problem);

}  // namespace taxel::studio
