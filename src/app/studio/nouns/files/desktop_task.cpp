#include "app/studio/nouns/files/desktop_task.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_task.h"
#include "core/layout/formats/format_table.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel::ui {

namespace {

using Extensions = std::vector<std::string_view>;

/// Returns "*.stl *.STL" for an extension: the dialogs of desktops compare the case.
std::string patterns_of(const Extensions& extensions) {
  std::string patterns;
  for (const std::string_view extension : extensions) {
    std::string upper(extension);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    for (const std::string_view name : {extension, std::string_view(upper)})
      patterns += (patterns.empty() ? "*" : " *") + std::string(name);
  }
  return patterns;
}

DesktopTask opens(const char* name, const Extensions& extensions) {
  return {false, {name, patterns_of(extensions)}};
}

DesktopTask saves(const char* name, const Extensions& extensions) {
  return {true, {name, patterns_of(extensions)}};
}

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

}  // namespace

std::optional<DesktopTask> desktop_task(FileTask task) {
  switch (task) {
    case FileTask::open:
      return opens("Projects, layouts, meshes, scenes and saved steps", document_extensions());
    case FileTask::save_project:
      return saves("Projects", {".taxelproj"});
    case FileTask::export_layout:
      return saves("Layouts", layout_extensions(true));
    case FileTask::export_taxels:
    case FileTask::export_samples:
    case FileTask::export_comparison:
      return saves("Tables", {".csv"});
    case FileTask::export_sheet:
      return saves("Sheets", {".html"});
    case FileTask::export_plot:
      return saves("Plots", {".svg", ".pdf"});
    case FileTask::export_frame:
      return saves("Saved steps", {".taxelframe"});
    case FileTask::export_recording:
    case FileTask::keep_recording:
      return saves("Recordings",
                   {".csv", ".npz", ".mcap", ".jsonl"});  // the folder of a recording is named in the same way
    case FileTask::export_picture:
    case FileTask::export_video:
      return std::nullopt;
    case FileTask::import_recording:
      return opens("Tables", {".csv", ".txt", ".tsv"});
    case FileTask::read_points:
      return opens("Tables and pictures", {".csv", ".txt", ".tsv", ".png", ".jpg", ".jpeg"});
    case FileTask::attach_layout:
    case FileTask::compare_layout:
      return opens("Layouts", layout_extensions(false));
    case FileTask::save_scene:
      return saves("MuJoCo scenes", {".xml"});
    case FileTask::save_study:
      return saves("Folders", {""});
    case FileTask::open_study:
      return opens("Data sets", {"info.json"});
  }
  return std::nullopt;
}

os::FileQuestion desktop_question(const FileDialog& dialog) {
  const DesktopTask task = desktop_task(dialog.task).value();
  return {task.saves,
          texts_of(dialog.task).title,
          path_in(dialog.folder, task.saves ? dialog.path : ""),
          {task.filter, {"All files", "*"}}};
}

}  // namespace taxel::ui
