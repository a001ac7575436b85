// The file dialog: the listed folder, the typed path and the file that would be replaced.
#pragma once

#include <string>
#include <vector>

#include "app/studio/nouns/files/file_task.h"

namespace taxel::ui {

/// One entry of a folder, listed by the program for the file dialog.
struct FolderEntry {
  std::string name;
  bool folder = false;
};

/// Whether the desktop's own file dialog can ask for files in place of the window's.
enum class DesktopChooser {
  unused,   ///< by scripts and by windows without a display
  missing,  ///< no program for it is installed
  found
};

struct FileDialog {
  FileTask task = FileTask::open;
  bool open = false;
  bool wants_focus = false;  ///< the path field gets the keyboard in the next frame
  std::string folder;        ///< absolute path of the listed folder
  std::vector<FolderEntry> entries;
  std::string path;    ///< text of the path field
  std::string filter;  ///< part of a name, any case
  int selected = -1;   ///< index in `entries`, or -1
  std::string error;   ///< why the folder could not be listed, or the file not be written
  std::string exists;  ///< existing file; requested a second time, it is replaced

  int width = 2400, height = 1800;  ///< size of an exported image [pixels]

  DesktopChooser desktop = DesktopChooser::unused;
  bool prefers_desktop = true;     ///< kept in the settings file
  bool waits_for_desktop = false;  ///< the desktop's dialog is to be opened for `task`
};

}  // namespace taxel::ui
