// The tasks of the file dialog: their texts, and the paths that the dialog forms.
#pragma once

#include <string>

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

struct TaskTexts {
  const char *title, *button;
  const char* extension;  ///< extension for a name without one; may be empty
};
[[nodiscard]] TaskTexts texts_of(FileTask task);
/// Returns the extension of the task's files; empty if any name is valid.
[[nodiscard]] const char* extension_of(FileTask task);

/// Returns the path of a file or folder in a folder.
[[nodiscard]] std::string path_in(const std::string& folder, const std::string& name);
/// Returns the folder that contains a folder; the root contains itself.
[[nodiscard]] std::string parent_of(const std::string& folder);

}  // namespace taxel::ui
