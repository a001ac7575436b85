#include "app/studio/nouns/files/file_task.h"

namespace taxel::ui {

TaskTexts texts_of(FileTask task) {
  switch (task) {
    case FileTask::open:
      return {"Open a project, layout, mesh, MuJoCo scene, saved step or data set", "Open", ""};
    case FileTask::save_project:
      return {"Save the project", "Save", ".taxelproj"};
    case FileTask::export_layout:
      return {"Export the layout", "Export", ".taxels.json"};
    case FileTask::export_taxels:
      return {"Export the taxels as a table", "Export", ".csv"};
    case FileTask::export_samples:
      return {"Export the samples as a table", "Export", ".csv"};
    case FileTask::export_sheet:
      return {"Export a sheet to print", "Export", ".html"};
    case FileTask::export_picture:
      return {"Export a picture on a transparent background", "Export", ".png"};
    case FileTask::export_plot:
      return {"Export the plot: NAME.svg or NAME.pdf", "Export", ".svg"};
    case FileTask::export_frame:
      return {"Save this step, to be opened elsewhere", "Save", ".taxelframe"};
    case FileTask::export_recording:
    case FileTask::keep_recording:
      return {"Write the recording: NAME.csv, .npz, .mcap or .jsonl, else a folder", "Export", ""};
    case FileTask::export_video:
      return {"Export a video: NAME.mp4 or .gif, else a folder of pictures", "Export", ""};
    case FileTask::import_recording:
      return {"A recording of a real sensor (CSV)", "Read", ""};
    case FileTask::read_points:
      return {"A table (CSV) or a picture (PNG, JPEG)", "Read", ""};
    case FileTask::attach_layout:
      return {"Attach a layout to the chosen geoms", "Attach", ""};
    case FileTask::compare_layout:
      return {"Open a second layout, for the mesh of the run", "Compare", ""};
    case FileTask::export_comparison:
      return {"Export the readings of both layouts", "Export", ".csv"};
    case FileTask::save_scene:
      return {"Save the scene with its sensors", "Save", ".xml"};
    case FileTask::save_study:
      return {"Save the study as a data set: a new folder", "Save", ""};
    case FileTask::open_study:
      return {"Open a data set as a study: its meta/info.json", "Open", ""};
  }
  return {"", "", ""};
}

const char* extension_of(FileTask task) {
  return texts_of(task).extension;
}

std::string path_in(const std::string& folder, const std::string& name) {
  return folder.empty() || folder.back() == '/' ? folder + name : folder + "/" + name;
}

std::string parent_of(const std::string& folder) {
  const std::size_t slash = folder.find_last_of('/', folder.size() > 1 ? folder.size() - 2 : 0);
  if (slash == std::string::npos) return folder;
  return slash == 0 ? "/" : folder.substr(0, slash);
}

}  // namespace taxel::ui
