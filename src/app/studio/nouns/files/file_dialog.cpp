#include "app/studio/nouns/files/file_dialog.h"

#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_dialog_tool.h"
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/video/video_card.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool passes(const FileDialog& dialog, const FolderEntry& entry) {
  return dialog.filter.empty() || lower(entry.name).find(lower(dialog.filter)) != std::string::npos;
}

void go_to(WindowUi& ui, FileDialog& dialog, const std::string& folder) {
  dialog.selected = -1;
  dialog.path.clear();
  dialog.filter.clear();
  ui.post(ListFolder{folder});
}

void close(FileDialog& dialog) {
  dialog.open = false;
  ImGui::CloseCurrentPopup();
}

/// Opens the path in the path field. A relative path starts at the displayed folder.
void accept(WindowUi& ui, const ControlsState& controls, FileDialog& dialog) {
  if (dialog.path.empty()) return;
  const std::string path = dialog.path.front() == '/' ? dialog.path : path_in(dialog.folder, dialog.path);
  const bool folder = std::any_of(dialog.entries.begin(), dialog.entries.end(),
                                  [&](const FolderEntry& e) { return e.folder && e.name == dialog.path; });
  if (folder) {
    go_to(ui, dialog, path);
  } else {
    ui.post(file_command(dialog, controls.geoms, path));
    close(dialog);
  }
}

/// Moves the selection with Up and Down through the entries that pass the filter, also while a field has the keyboard.
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

/// Returns the number of rows of the task's settings, above the buttons.
float setting_rows(FileTask task) {
  return task == FileTask::export_video ? kVideoSettingRows : task == FileTask::export_picture ? 1 : 0;
}

void draw_entries(WindowUi& ui, const ControlsState& controls, FileDialog& dialog) {
  const float rows = 2 + setting_rows(dialog.task);
  const float below = rows * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  if (ImGui::BeginChild("entries", ImVec2(0, -below), ImGuiChildFlags_FrameStyle)) {
    if (selectable(ui, "..", false)) go_to(ui, dialog, parent_of(dialog.folder));
    for (int i = 0; i < static_cast<int>(dialog.entries.size()); ++i) {
      const FolderEntry entry = dialog.entries[static_cast<std::size_t>(i)];
      if (!passes(dialog, entry)) continue;
      const bool chosen = dialog.selected == i;
      const std::string label = entry.folder ? entry.name + "/" : entry.name;
      if (selectable(ui, label.c_str(), chosen, ImGuiSelectableFlags_AllowDoubleClick)) {
        dialog.selected = i;
        dialog.path = entry.name;
        if (entry.folder) {
          go_to(ui, dialog, path_in(dialog.folder, entry.name));
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

/// Draws the fields of an image's size, in pixels.
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
  if (dialog.task == FileTask::export_video) draw_video_settings(ui, video, dialog.path);
  ImGui::SetNextItemWidth(14 * ImGui::GetFontSize());
  ImGui::InputTextWithHint("##filter", "Filter names", &dialog.filter);
  ui.widgets.note_item("Filter");
  const float width = 6 * ImGui::GetFontSize();
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - 2 * width -
                  ImGui::GetStyle().ItemSpacing.x);
  const bool cancelled = button(ui, "Cancel", ImVec2(width, 0)) || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  ImGui::SameLine();
  const bool opened = button(ui, texts_of(dialog.task).button, ImVec2(width, 0));
  if (cancelled) {
    close(dialog);
    ui.post(DialogClosed{});
  } else if (entered || opened) {
    accept(ui, controls, dialog);
  }
}

}  // namespace

void draw_file_dialog(WindowUi& ui, const ControlsState& controls, VideoState& video, FileDialog& dialog) {
  const char* const title = texts_of(dialog.task).title;
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
