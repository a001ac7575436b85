#include "app/studio/nouns/files/file_dialog.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "core/base/os/process.h"
#include "core/layout/formats/layout_format.h"
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

/// Returns the extensions of documents, as documents.h knows them, and of studies.
Extensions document_extensions() {
  Extensions extensions{".taxelproj", ".taxelframe", "batch.json"};
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
  return {".csv", ".npz", ".jsonl"};
}

constexpr const char* kWriteRecording =
    "Write the recording: .csv, .npz, .jsonl or a folder (MCAP: python -m taxel.mcap)";
constexpr bool kReads = false, kWrites = true;

// The rows in the order of the enumerators: texts; extension of a name without one; files for the desktop's dialog.
constexpr std::array kTaskRows = {
    FileTaskRow{FileTask::open, "Open a project, layout, mesh, MuJoCo scene, saved step or study", "Open", "", kReads,
                "Projects, layouts, meshes, scenes, saved steps and studies", document_extensions},
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
    FileTaskRow{FileTask::export_video, "Export a video: NAME.webp, .mp4 or .gif, else a folder of pictures", "Export",
                "", kWrites, nullptr, nullptr},
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
    FileTaskRow{FileTask::export_fits, "Export the fit of the real recording", "Export", ".csv", kWrites, "Tables",
                [] { return Extensions{".csv"}; }},
    FileTaskRow{FileTask::save_scene, "Save the scene with its sensors", "Save", ".xml", kWrites, "MuJoCo scenes",
                [] { return Extensions{".xml"}; }},
    FileTaskRow{FileTask::save_study, "Save the study as a batch: a new folder", "Save", "", kWrites, "Folders",
                [] { return Extensions{""}; }},
    FileTaskRow{FileTask::open_study, "Open a study: the batch.json of its folder", "Open", "", kReads, "Batches",
                [] { return Extensions{"batch.json"}; }},
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kTaskRows.size(); ++i)
    if (kTaskRows[i].task != static_cast<FileTask>(i)) return false;
  return kTaskRows.back().task == FileTask::open_study;
}
static_assert(is_in_order());

}  // namespace

const FileTaskRow& row_of(FileTask task) {
  return kTaskRows[static_cast<std::size_t>(task)];
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

namespace taxel::ui {

bool uses_desktop(const FileDialog& dialog) {
  return dialog.prefers_desktop && dialog.desktop == DesktopChooser::found;
}

const char* why_no_desktop(const FileDialog& dialog) {
  switch (dialog.desktop) {
    case DesktopChooser::unused:
      return "Scripts and windows without a display use the window's own file dialog";
    case DesktopChooser::missing:
      return "No desktop file dialog found: install zenity or kdialog";
    case DesktopChooser::found:
      break;
  }
  return "";
}

void begin_own_dialog(FileDialog& dialog, FileTask task) {
  dialog.task = task;
  dialog.open = dialog.wants_focus = true;
  dialog.waits_for_desktop = false;
  dialog.path.clear();
  dialog.filter.clear();
  dialog.exists.clear();
  dialog.typed = {};
}

void begin_dialog(FileDialog& dialog, FileTask task) {
  begin_own_dialog(dialog, task);
  dialog.waits_for_desktop = uses_desktop(dialog) && desktop_task(task);
  if (dialog.waits_for_desktop) dialog.open = dialog.wants_focus = false;
}

void open_dialog(WindowUi& ui, FileDialog& dialog) {
  begin_dialog(dialog, FileTask::open);
  ui.post(ListFolder{dialog.folder});
}

}  // namespace taxel::ui

namespace taxel::studio {

namespace fs = std::filesystem;

namespace {

bool can_be_opened(const fs::path& file) {
  return why_not_opened(file).empty();
}

}  // namespace

namespace {

/// Returns the entries of a folder: its folders, and the files that `wanted` returns true for. Hidden ones are left
/// out. `error` says why the folder cannot be read.
std::vector<ui::FolderEntry> entries_of(const fs::path& folder, bool (*wanted)(const fs::path& file),
                                        std::error_code& error) {
  std::vector<ui::FolderEntry> entries;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code unreadable;
    const bool is_folder = it->is_directory(unreadable);
    if (name.starts_with('.') || (!is_folder && !wanted(it->path()))) continue;
    ui::FolderEntry& entry = entries.emplace_back(ui::FolderEntry{name, is_folder});
    const std::uintmax_t bytes = is_folder ? 0 : it->file_size(unreadable);
    entry.bytes = unreadable ? 0 : bytes;
    const fs::file_time_type time = it->last_write_time(unreadable);
    if (unreadable) continue;
    const auto since_1970 = std::chrono::file_clock::to_sys(time).time_since_epoch();
    entry.changed = std::chrono::duration_cast<std::chrono::seconds>(since_1970).count();
  }
  return entries;
}

/// Returns the predicate for the files of a task.
auto files_of(ui::FileTask task) {
  return task == ui::FileTask::read_points || task == ui::FileTask::import_recording ? holds_points : can_be_opened;
}

}  // namespace

std::string why_not_opened(const fs::path& file) {
  if (batch_folder(file)) return "";
  try {
    document_kind(file);
  } catch (const Error& error) {
    const char* const remedy = is_picture(file) ? ". Edit > Generate taxels reads the dots of an image" : "";
    return error.message() + remedy;
  }
  std::error_code ignored;
  if (!needs_mesh(file) || !fs::is_regular_file(file, ignored) || looks_like_foreign_layout(file)) return "";
  return fmt::format("cannot be opened: a {} file can hold a layout, but the text of this one is none",
                     file.extension().string());
}

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
  dialog.error.clear();
  std::vector<ui::FolderEntry> entries;
  if (!error) entries = entries_of(path, files_of(dialog.task), error);
  if (error) {
    dialog.error =
        fmt::format("The folder {} cannot be listed: {}. Choose another one.", path.string(), error.message());
    return;
  }
  dialog.folder = path.string();
  dialog.entries = std::move(entries);
  dialog.selected = -1;
  dialog.typed = {};
  ui::sort_entries(dialog.entries, dialog.order);
}

void find_places(ui::FileDialog& dialog, const std::string& open_file) {
  const std::string home = os::variable("HOME");
  dialog.places = {{"Home", home.empty() ? "/" : home}};
  std::error_code error;
  const std::string working = fs::current_path(error).string();
  const auto add = [&](const char* label, const std::string& folder) {
    const auto is_same = [&](const ui::DialogPlace& place) { return place.folder == folder; };
    if (!folder.empty() && std::none_of(dialog.places.begin(), dialog.places.end(), is_same))
      dialog.places.push_back({label, folder});
  };
  add("Working folder", working);
  if (!open_file.empty()) add("Folder of the open file", fs::path(open_file).parent_path().string());
}

}  // namespace taxel::studio

namespace taxel::ui {

void carry_out(const ListFolder& command, App& app) {
  studio::find_places(app.get<FileDialog>(), app.shown->document.file);
  studio::list_folder(app.get<FileDialog>(), command.path);
}

void carry_out(const ListTyped& command, App& app) {
  FileDialog& dialog = app.get<FileDialog>();
  std::error_code error;
  dialog.typed.is_folder = std::filesystem::is_directory(command.path, error);
  dialog.typed.entries =
      studio::entries_of(std::filesystem::path(command.path).parent_path(), studio::files_of(dialog.task), error);
}

std::string typed_path(const FileDialog& dialog, const std::string& text) {
  if (text.starts_with("~/") && !dialog.places.empty()) return path_in(dialog.places.front().folder, text.substr(2));
  return text.starts_with('/') ? text : path_in(dialog.folder, text);
}

std::string completion(const FileDialog& dialog, const std::string& text) {
  const std::string begin = text.substr(text.find_last_of('/') + 1);
  std::string longest;
  int count = 0;
  bool is_folder = false;
  for (const FolderEntry& entry : dialog.typed.entries) {
    if (!entry.name.starts_with(begin)) continue;
    if (count++ == 0) {
      longest = entry.name;
      is_folder = entry.folder;
    } else {
      const auto differs = std::mismatch(longest.begin(), longest.end(), entry.name.begin(), entry.name.end());
      longest.erase(differs.first, longest.end());
    }
  }
  if (count == 0) return "";
  return longest.substr(begin.size()) + (count == 1 && is_folder ? "/" : "");
}

void sort_entries(std::vector<FolderEntry>& entries, EntryOrder order) {
  const auto value = [&](const FolderEntry& entry) {
    const bool by_size = order.column == EntryColumn::size, by_time = order.column == EntryColumn::changed;
    return by_size ? static_cast<std::int64_t>(entry.bytes) : by_time ? entry.changed : 0;
  };
  std::sort(entries.begin(), entries.end(), [&](const FolderEntry& a, const FolderEntry& b) {
    if (a.folder != b.folder) return a.folder;
    if (value(a) != value(b)) return order.descending ? value(a) > value(b) : value(a) < value(b);
    return order.descending && order.column == EntryColumn::name ? a.name > b.name : a.name < b.name;
  });
}

}  // namespace taxel::ui

namespace taxel::studio {

void ask_for_file(ui::App& app, ui::FileTask task, const std::string& problem) {
  const bool again = app.get<ui::FileDialog>().task == task && !problem.empty();
  const std::string typed = app.get<ui::FileDialog>().path;
  problem.empty() ? ui::begin_dialog(app.get<ui::FileDialog>(), task)
                  : ui::begin_own_dialog(app.get<ui::FileDialog>(), task);
  const bool folder = task == ui::FileTask::export_recording || task == ui::FileTask::keep_recording;
  const SuggestedFile suggested = suggested_file(app.shown->document.file, app.shown->document.name,
                                                 folder                               ? "-recording"
                                                 : task == ui::FileTask::export_video ? "-video.webp"
                                                 : task == ui::FileTask::save_scene   ? "_taxels.xml"
                                                                                      : ui::row_of(task).extension);
  find_places(app.get<ui::FileDialog>(), app.shown->document.file);
  list_folder(app.get<ui::FileDialog>(),
              suggested.folder.empty() || again ? app.get<ui::FileDialog>().folder : suggested.folder);
  app.get<ui::FileDialog>().path = again ? typed : suggested.name;
  app.get<ui::FileDialog>().error = problem;
}

}  // namespace taxel::studio

namespace taxel::ui {
namespace {

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

}  // namespace

std::optional<DesktopTask> desktop_task(FileTask task) {
  const FileTaskRow& row = row_of(task);
  if (row.files == nullptr) return std::nullopt;
  return DesktopTask{row.saves, {row.files, patterns_of(row.extensions())}};
}

os::FileQuestion desktop_question(const FileDialog& dialog) {
  const DesktopTask task = desktop_task(dialog.task).value();
  return {task.saves,
          row_of(dialog.task).title,
          path_in(dialog.folder, task.saves ? dialog.path : ""),
          {task.filter, {"All files", "*"}}};
}

}  // namespace taxel::ui
