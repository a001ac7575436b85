// The tasks of the file dialog, one row each, and the paths that the dialog forms.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taxel::ui {

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
  save_scene,
  save_study,  ///< the displayed study, as a data set
  open_study   ///< a data set in the panel of studies
};

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

}  // namespace taxel::ui
