// The file dialog: its task, the listed folder, the typed path and the file that would be replaced.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace taxel::ui {

/// The question of the dialog.
enum class FileTask {
  open,
  save_project,
  export_layout,
  export_taxels,
  export_samples,
  export_sheet,
  export_picture,
  export_plot,  ///< readings over travel or time
  export_frame,
  export_recording,  ///< the recorded steps
  keep_recording,    ///< one that could not be written where it was to be
  export_video,
  import_recording,  ///< the table of a real sensor
  read_points,
  attach_layout,
  compare_layout,     ///< a second layout for the run
  export_comparison,  ///< the readings of both layouts
  export_fits,        ///< gains of a real recording
  save_scene,
  save_study,  ///< the displayed study, as a batch
  open_study   ///< a batch in the panel of studies
};

/// One entry of a folder, listed by the program for the file dialog.
struct FolderEntry {
  std::string name;
  bool folder = false;
  std::uint64_t bytes = 0;   ///< size of a file
  std::int64_t changed = 0;  ///< time of the last change [s] since 1970, or 0 if unknown
};

/// Columns by which the entries can be sorted, in the order of the table.
enum class EntryColumn { name, size, changed };

/// Order of the entries. Folders come first in any order.
struct EntryOrder {
  EntryColumn column = EntryColumn::name;
  bool descending = false;
};

/// A folder that the dialog offers.
struct DialogPlace {
  std::string label;
  std::string folder;
};

/// The folder that the typed path names.
struct TypedPath {
  std::string text;                  ///< text of the path field that was looked up
  bool is_folder = false;            ///< whether the text is the path of a folder
  std::vector<FolderEntry> entries;  ///< entries of the folder in which the last part of the text is
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
  EntryOrder order;
  std::vector<DialogPlace> places;
  TypedPath typed;
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
