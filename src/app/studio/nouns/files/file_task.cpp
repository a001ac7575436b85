#include "app/studio/nouns/files/file_task.h"

#include <algorithm>
#include <array>

#include "core/layout/formats/format_table.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel::ui {

namespace {

using Extensions = std::vector<std::string_view>;

/// Returns the extensions of all layouts, or of those that can be written.
Extensions layout_extensions(bool writable) {
  Extensions extensions;
  for (const LayoutFormat& format : layout_formats()) {
    if (format.is_refused || (writable && format.write == nullptr)) continue;
    for (const std::string_view extension : format.extensions)
      if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
        extensions.push_back(extension);
  }
  return extensions;
}

/// Returns the extensions of documents, as documents.h knows them.
Extensions document_extensions() {
  Extensions extensions{".taxelproj", ".taxelframe"};
  const Extensions layouts = layout_extensions(false);  // scenes among them
  extensions.insert(extensions.end(), layouts.begin(), layouts.end());
  for (const MeshFormat& format : kMeshFormats)
    if (can_read(format)) extensions.push_back(format.extension);
  return extensions;
}

Extensions all_layouts() {
  return layout_extensions(false);
}

Extensions written_layouts() {
  return layout_extensions(true);
}

/// The folder of a recording is named as a file is.
Extensions recordings() {
  return {".csv", ".npz", ".mcap", ".jsonl"};
}

constexpr const char* kWriteRecording = "Write the recording: NAME.csv, .npz, .mcap or .jsonl, else a folder";
constexpr bool kReads = false, kWrites = true;

// The rows in the order of the enumerators: texts; extension of a name without one; files for the desktop's dialog.
constexpr std::array kRows = {
    FileTaskRow{FileTask::open, "Open a project, layout, mesh, MuJoCo scene, saved step or data set", "Open", "",
                kReads, "Projects, layouts, meshes, scenes and saved steps", document_extensions},
    FileTaskRow{FileTask::save_project, "Save the project", "Save", ".taxelproj", kWrites, "Projects",
                [] { return Extensions{".taxelproj"}; }},
    FileTaskRow{FileTask::export_layout, "Export the layout", "Export", ".taxels.json", kWrites, "Layouts",
                written_layouts},
    FileTaskRow{FileTask::export_taxels, "Export the taxels as a table", "Export", ".csv", kWrites, "Tables",
                [] { return Extensions{".csv"}; }},
    FileTaskRow{FileTask::export_samples, "Export the samples as a table", "Export", ".csv", kWrites, "Tables",
                [] { return Extensions{".csv"}; }},
    FileTaskRow{FileTask::export_sheet, "Export a sheet to print", "Export", ".html", kWrites, "Sheets",
                [] { return Extensions{".html"}; }},
    FileTaskRow{FileTask::export_picture, "Export a picture on a transparent background", "Export", ".png", kWrites,
                nullptr, nullptr},
    FileTaskRow{FileTask::export_plot, "Export the plot: NAME.svg or NAME.pdf", "Export", ".svg", kWrites, "Plots",
                [] {
                  return Extensions{".svg", ".pdf"};
                }},
    FileTaskRow{FileTask::export_frame, "Save this step, to be opened elsewhere", "Save", ".taxelframe", kWrites,
                "Saved steps", [] { return Extensions{".taxelframe"}; }},
    FileTaskRow{FileTask::export_recording, kWriteRecording, "Export", "", kWrites, "Recordings", recordings},
    FileTaskRow{FileTask::keep_recording, kWriteRecording, "Export", "", kWrites, "Recordings", recordings},
    FileTaskRow{FileTask::export_video, "Export a video: NAME.mp4 or .gif, else a folder of pictures", "Export", "",
                kWrites, nullptr, nullptr},
    FileTaskRow{FileTask::import_recording, "A recording of a real sensor (CSV)", "Read", "", kReads, "Tables",
                [] {
                  return Extensions{".csv", ".txt", ".tsv"};
                }},
    FileTaskRow{FileTask::read_points, "A table (CSV) or a picture (PNG, JPEG)", "Read", "", kReads,
                "Tables and pictures", [] { return Extensions{".csv", ".txt", ".tsv", ".png", ".jpg", ".jpeg"}; }},
    FileTaskRow{FileTask::attach_layout, "Attach a layout to the chosen geoms", "Attach", "", kReads, "Layouts",
                all_layouts},
    FileTaskRow{FileTask::compare_layout, "Open a second layout, for the mesh of the run", "Compare", "", kReads,
                "Layouts", all_layouts},
    FileTaskRow{FileTask::export_comparison, "Export the readings of both layouts", "Export", ".csv", kWrites, "Tables",
                [] { return Extensions{".csv"}; }},
    FileTaskRow{FileTask::save_scene, "Save the scene with its sensors", "Save", ".xml", kWrites, "MuJoCo scenes",
                [] { return Extensions{".xml"}; }},
    FileTaskRow{FileTask::save_study, "Save the study as a data set: a new folder", "Save", "", kWrites, "Folders",
                [] { return Extensions{""}; }},
    FileTaskRow{FileTask::open_study, "Open a data set as a study: its meta/info.json", "Open", "", kReads, "Data sets",
                [] { return Extensions{"info.json"}; }},
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].task != static_cast<FileTask>(i)) return false;
  return kRows.back().task == FileTask::open_study;
}
static_assert(is_in_order());

}  // namespace

const FileTaskRow& row_of(FileTask task) {
  return kRows[static_cast<std::size_t>(task)];
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
