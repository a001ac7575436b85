#include "app/studio/features/files/file_dialog.h"

#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "app/studio/features/video/video_card.h"
#include "core/layout/file/layout_format.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

struct Words {
  const char *title, *button;
  const char* extension;  ///< that a name gets which has none
};

Words words_of(FileTask task) {
  switch (task) {
    case FileTask::open:
      return {"Open a project, layout, mesh, MuJoCo scene or saved step", "Open", ""};
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
    case FileTask::export_frame:
      return {"Save this step, to be opened elsewhere", "Save", ".taxelframe"};
    case FileTask::export_recording:
    case FileTask::keep_recording:
      return {"Write the recording: NAME.csv, .npz or .jsonl, else a folder", "Export", ""};
    case FileTask::export_video:
      return {"Export a video: NAME.mp4 or .gif, else a folder of pictures", "Export", ""};
    case FileTask::import_recording:
      return {"A recording of a real sensor (CSV)", "Read", ""};
    case FileTask::read_points:
      return {"A table (CSV) or a picture (PNG, JPEG)", "Read", ""};
    case FileTask::attach_layout:
      return {"Attach a layout to the chosen geoms", "Attach", ""};
    case FileTask::save_scene:
      return {"Save the scene with its sensors", "Save", ".xml"};
  }
  return {"", "", ""};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool passes(const FileDialog& dialog, const FolderEntry& entry) {
  return dialog.filter.empty() || lower(entry.name).find(lower(dialog.filter)) != std::string::npos;
}

std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() || folder.back() == '/' ? folder + name : folder + "/" + name;
}

std::string parent(const std::string& folder) {
  const std::size_t slash = folder.find_last_of('/', folder.size() > 1 ? folder.size() - 2 : 0);
  if (slash == std::string::npos) return folder;
  return slash == 0 ? "/" : folder.substr(0, slash);
}

void go_to(WindowUi& ui, FileDialog& dialog, const std::string& folder) {
  dialog.selected = -1;
  dialog.path.clear();
  dialog.filter.clear();
  ui.post(ListFolder{folder});
}

bool names_format(const std::string& path) {
  const LayoutFormat* format = layout_format_of(path);
  return format != nullptr && format->write != nullptr;
}

void ask_for(WindowUi& ui, const ControlsState& controls, const FileDialog& dialog, const std::string& path) {
  if (dialog.task == FileTask::open) return ui.post(OpenFile{path});
  if (dialog.task == FileTask::import_recording) return ui.post(ReadRealRecording{path});
  if (dialog.task == FileTask::read_points) return ui.post(ReadPoints{path});
  if (dialog.task == FileTask::attach_layout) return ui.post(AttachLayout{controls.geoms, path});
  const std::string extension = words_of(dialog.task).extension;
  // A layout goes out in any format that its name asks for.
  const bool complete = path.ends_with(extension) || (dialog.task == FileTask::export_layout && names_format(path));
  const std::string whole = complete ? path : path + extension;
  const bool replace = whole == dialog.exists;
  if (dialog.task == FileTask::save_project) {
    ui.post(SaveProject{whole, replace});
  } else if (dialog.task == FileTask::save_scene) {
    ui.post(SaveScene{whole, replace});
  } else {
    ui.post(ExportFile{dialog.task, whole, replace, dialog.width, dialog.height});
  }
}

void close(FileDialog& dialog) {
  dialog.open = false;
  ImGui::CloseCurrentPopup();
}

/// Opens what stands in the path field: relative paths count from the folder shown.
void accept(WindowUi& ui, const ControlsState& controls, FileDialog& dialog) {
  if (dialog.path.empty()) return;
  const std::string path = dialog.path.front() == '/' ? dialog.path : joined(dialog.folder, dialog.path);
  const bool folder = std::any_of(dialog.entries.begin(), dialog.entries.end(),
                                  [&](const FolderEntry& e) { return e.folder && e.name == dialog.path; });
  if (folder) {
    go_to(ui, dialog, path);
  } else {
    ask_for(ui, controls, dialog, path);
    close(dialog);
  }
}

/// Up and Down walk through the entries that pass the filter, also while a field has the keyboard.
void walk(FileDialog& dialog) {
  const int step = (ImGui::IsKeyPressed(ImGuiKey_DownArrow) ? 1 : 0) - (ImGui::IsKeyPressed(ImGuiKey_UpArrow) ? 1 : 0);
  if (step == 0) return;
  const int count = static_cast<int>(dialog.entries.size());
  for (int i = dialog.selected + step; i >= 0 && i < count; i += step) {
    const FolderEntry& entry = dialog.entries[static_cast<std::size_t>(i)];
    if (!passes(dialog, entry)) continue;
    dialog.selected = i;
    dialog.path = entry.name;
    return;
  }
}

/// In a row above the buttons.
bool has_settings(FileTask task) {
  return task == FileTask::export_picture || task == FileTask::export_video;
}

void draw_entries(WindowUi& ui, const ControlsState& controls, FileDialog& dialog) {
  const float rows = has_settings(dialog.task) ? 3 : 2;
  const float below = rows * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  if (ImGui::BeginChild("entries", ImVec2(0, -below), ImGuiChildFlags_FrameStyle)) {
    if (selectable(ui, "..", false)) go_to(ui, dialog, parent(dialog.folder));
    for (int i = 0; i < static_cast<int>(dialog.entries.size()); ++i) {
      const FolderEntry entry = dialog.entries[static_cast<std::size_t>(i)];
      if (!passes(dialog, entry)) continue;
      const bool chosen = dialog.selected == i;
      const std::string label = entry.folder ? entry.name + "/" : entry.name;
      if (selectable(ui, label.c_str(), chosen, ImGuiSelectableFlags_AllowDoubleClick)) {
        dialog.selected = i;
        dialog.path = entry.name;
        if (entry.folder) {
          go_to(ui, dialog, joined(dialog.folder, entry.name));
        } else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
          accept(ui, controls, dialog);
        }
      }
      if (chosen && ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ImGui::SetScrollHereY();
    }
    if (!dialog.error.empty()) {
      ImGui::PushTextWrapPos(0);
      ImGui::TextColored(palette(ui.dark).error, "%s", dialog.error.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::EndChild();
}

/// Of a picture, in pixels.
void draw_size(WindowUi& ui, FileDialog& dialog) {
  const auto field = [&](const char* label, int* value) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    ImGui::InputInt((std::string("##") + label).c_str(), value, 0);
    ui.widgets.note_item(label);
  };
  field("Width", &dialog.width);
  ImGui::SameLine();
  field("Height", &dialog.height);
  ImGui::SameLine();
  ImGui::TextDisabled("pixels");
}

void draw_path_and_buttons(WindowUi& ui, const ControlsState& controls, VideoState& video, FileDialog& dialog) {
  ImGui::SetNextItemWidth(-1);
  if (dialog.wants_focus) ImGui::SetKeyboardFocusHere();
  dialog.wants_focus = false;
  const bool entered =
      ImGui::InputTextWithHint("##path", "Path or name", &dialog.path, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note_item("Path");
  if (dialog.task == FileTask::export_picture) draw_size(ui, dialog);
  if (dialog.task == FileTask::export_video) draw_video_settings(ui, video);
  ImGui::SetNextItemWidth(14 * ImGui::GetFontSize());
  ImGui::InputTextWithHint("##filter", "Filter names", &dialog.filter);
  ui.widgets.note_item("Filter");
  const float width = 6 * ImGui::GetFontSize();
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - 2 * width -
                  ImGui::GetStyle().ItemSpacing.x);
  const bool cancelled = button(ui, "Cancel", ImVec2(width, 0)) || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  ImGui::SameLine();
  const bool opened = button(ui, words_of(dialog.task).button, ImVec2(width, 0));
  if (cancelled) {
    close(dialog);
    ui.post(DialogClosed{});
  } else if (entered || opened) {
    accept(ui, controls, dialog);
  }
}

}  // namespace

const char* extension_of(FileTask task) {
  return words_of(task).extension;
}

void draw_file_dialog(WindowUi& ui, const ControlsState& controls, VideoState& video, FileDialog& dialog) {
  const char* const title = words_of(dialog.task).title;
  if (dialog.open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  place_dialog(46, 30);
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDocking)) return;
  ImGui::TextDisabled("%s", dialog.folder.c_str());
  ui.widgets.note_item("Folder");
  walk(dialog);
  draw_entries(ui, controls, dialog);
  draw_path_and_buttons(ui, controls, video, dialog);
  ImGui::EndPopup();
}

}  // namespace taxel::ui
