// Floating windows about files: the start card, the file dialog, notices, and questions about unsaved work and
// recovery.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <limits>
#include <string>
#include <string_view>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/desktop_dialog.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/video/video_state.h"
#include "core/mesh/formats/mesh_format.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {
namespace {

const char* words_of(FileOffer offer) {
  switch (offer) {
    case FileOffer::reload:
      return "Read it again";
    case FileOffer::use_mesh:
      return "Use this mesh";
    case FileOffer::project_back:
      return "Use it, taxels onto its surface";
    case FileOffer::locate:
      return "Locate...";
  }
  return "";
}

/// Draws a notice and returns its height.
float draw_notice(WindowUi& ui, const FileNotice& notice, ImVec2 top, float width) {
  const Palette& colors = palette(ui.dark);
  ImGui::SetNextWindowPos(top, ImGuiCond_Always, ImVec2(0.5f, 0));
  ImGui::SetNextWindowSize(ImVec2(width, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, colors.warning);
  ImGui::PushStyleColor(ImGuiCol_Button, colors.panel);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                          ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin(("File notice##" + notice.file).c_str(), nullptr, kFlags);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(notice.text.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item("File notice");
  for (const FileOffer offer : notice.offers) {
    if (button(ui, words_of(offer))) ui.post(AnswerNotice{notice.file, offer});
    ImGui::SameLine();
  }
  if (button(ui, notice.offers.empty() ? "Understood" : "Leave as it is")) ui.post(AnswerNotice{notice.file, {}});
  const float height = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleColor(3);
  return height;
}

/// Draws one popup per notice at the top of the view, with the possible remedies.
void draw_file_notices(WindowUi& ui, const ViewPlace& place, const std::vector<FileNotice>& notices) {
  const float em = ImGui::GetFontSize();
  const Rect& view = place.rect;
  const float width = std::min(36 * em, view.x1 - view.x0 - 2 * em);
  ImVec2 top(view.center_x(), view.y0 + 3 * em);
  for (const FileNotice& notice : notices) top.y += draw_notice(ui, notice, top, width) + 0.5f * em;
}

// Lengths in heights of text.
constexpr float kPlacesColumn = 11, kSizeColumn = 5.5f, kDateColumn = 9.5f;

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool passes(const FileDialog& dialog, const FolderEntry& entry) {
  return dialog.filter.empty() || in_lower_case(entry.name).find(in_lower_case(dialog.filter)) != std::string::npos;
}

void go_to(WindowUi& ui, FileDialog& dialog, const std::string& folder) {
  dialog.selected = -1;
  if (!row_of(dialog.task).saves) dialog.path.clear();  // the name of a file to write stays
  dialog.filter.clear();
  ui.post(ListFolder{folder});
}

void close(FileDialog& dialog) {
  dialog.open = false;
  ImGui::CloseCurrentPopup();
}

std::string name_in_path(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

/// Opens the path in the path field, or lists it if it is a folder. A batch is a folder itself: one that exists already
/// is refused with its reason.
void accept(App& app, FileDialog& dialog) {
  if (dialog.path.empty()) return;
  const std::string path = typed_path(dialog, dialog.path);
  const bool is_listed = std::any_of(dialog.entries.begin(), dialog.entries.end(),
                                     [&](const FolderEntry& e) { return e.folder && e.name == dialog.path; });
  if ((is_listed || dialog.typed.is_folder) && dialog.task != FileTask::save_study) {
    dialog.path.clear();
    dialog.wants_focus = true;  // a name in the folder is typed there
    return go_to(*app.ui, dialog, path);
  }
  if (dialog.task == FileTask::open) {
    const std::string why_not = studio::why_not_opened(path);
    dialog.error = why_not.empty() ? "" : name_in_path(path) + " " + why_not;
    dialog.wants_focus = !why_not.empty();  // the next name is typed there
    if (!why_not.empty()) return;
  }
  app.ui->post(file_command(dialog, app.get<ControlsState>().geoms, path));
  close(dialog);
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

/// Draws a row of the column of places, with its whole path as a tooltip. Returns whether it was clicked.
bool draw_place(WindowUi& ui, const std::string& label, const std::string& path) {
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(path.c_str());
  const bool clicked = ImGui::Selectable(shortened(label, room, 1).c_str());
  ImGui::PopID();
  ui.widgets.note_item("Place " + label);
  tooltip(path);
  return clicked;
}

/// Draws the column of places, and of recent files where a document is to be opened.
void draw_places(App& app, FileDialog& dialog, float height) {
  if (ImGui::BeginChild("places", ImVec2(kPlacesColumn * ImGui::GetFontSize(), height), ImGuiChildFlags_FrameStyle)) {
    ImGui::TextDisabled("Places");
    for (const DialogPlace& place : dialog.places)
      if (draw_place(*app.ui, place.label, place.folder)) go_to(*app.ui, dialog, place.folder);
    const bool opens = dialog.task == FileTask::open;
    if (opens &&
        draw_place(*app.ui, "Examples", "The files of the examples, which are written to a folder of their own"))
      app.ui->post(OpenExamples{});
    if (const std::vector<std::string>& recent = app.get<FilesState>().recent; opens && !recent.empty()) {
      ImGui::Spacing();
      ImGui::TextDisabled("Recent");
      for (const std::string& file : recent) {
        if (!draw_place(*app.ui, name_in_path(file), file)) continue;
        app.ui->post(OpenFile{file});
        close(dialog);
      }
    }
  }
  ImGui::EndChild();
}

/// Sorts the entries by the column whose head was clicked.
void sort_by_head(FileDialog& dialog) {
  ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (specs == nullptr || !specs->SpecsDirty || specs->SpecsCount == 0) return;
  dialog.order = {static_cast<EntryColumn>(specs->Specs->ColumnIndex),
                  specs->Specs->SortDirection == ImGuiSortDirection_Descending};
  specs->SpecsDirty = false;
  dialog.selected = -1;
  sort_entries(dialog.entries, dialog.order);
}

/// Draws the row of an entry. Returns whether the entry was clicked.
bool draw_entry_row(WindowUi& ui, const FolderEntry& entry, bool is_chosen) {
  const Palette& colors = palette(ui.dark);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = entry.folder ? entry.name + "/" : entry.name;
  constexpr auto kFlags = ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_SpanAllColumns;
  const bool clicked = selectable(ui, label.c_str(), is_chosen, kFlags);
  ImGui::TableNextColumn();
  if (!entry.folder) ImGui::TextColored(colors.dim, "%s", bytes_text(static_cast<double>(entry.bytes)).c_str());
  ImGui::TableNextColumn();
  if (entry.changed != 0)
    ImGui::TextColored(
        colors.dim, "%s",
        fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(static_cast<std::time_t>(entry.changed))).c_str());
  return clicked;
}

/// Lists the folder whose row was clicked. The second click of a double click hits a row of the new list, so it counts
/// as a first click there and opens nothing.
void list_by_click(WindowUi& ui, FileDialog& dialog, const std::string& folder) {
  ImGui::GetIO().MouseClickedTime[ImGuiMouseButton_Left] = -std::numeric_limits<float>::max();
  go_to(ui, dialog, folder);
}

/// Draws the listed folder as a table.
void draw_entries(App& app, FileDialog& dialog, float height) {
  const float line = ImGui::GetFontSize();
  constexpr auto kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("entries", 3, kFlags, ImVec2(0, height))) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort);
  ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, kSizeColumn * line);
  ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed, kDateColumn * line);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int column = 0; column < 3; ++column) {
    ImGui::TableSetColumnIndex(column);
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    app.ui->widgets.note_item(std::string("Sort by ") + ImGui::TableGetColumnName(column));
  }
  sort_by_head(dialog);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (selectable(*app.ui, "..", false, ImGuiSelectableFlags_SpanAllColumns))
    list_by_click(*app.ui, dialog, parent_of(dialog.folder));
  bool has_any = false;
  for (int i = 0; i < static_cast<int>(dialog.entries.size()); ++i) {
    const FolderEntry entry = dialog.entries[static_cast<std::size_t>(i)];
    if (!passes(dialog, entry)) continue;
    has_any = true;
    const bool is_chosen = dialog.selected == i;
    if (draw_entry_row(*app.ui, entry, is_chosen)) {
      dialog.selected = i;
      if (entry.folder) {
        list_by_click(*app.ui, dialog, path_in(dialog.folder, entry.name));
      } else {
        dialog.path = entry.name;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) accept(app, dialog);
      }
    }
    if (is_chosen && ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ImGui::SetScrollHereY();
  }
  if (!has_any && dialog.error.empty()) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s",
                        dialog.filter.empty() ? "Nothing of this kind is in this folder." : "No name has this in it.");
  }
  ImGui::EndTable();
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

/// Completes the typed path with Tab.
int complete_path(ImGuiInputTextCallbackData* data) {
  const auto& dialog = *static_cast<const FileDialog*>(data->UserData);
  const std::string typed(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  const std::string added = completion(dialog, typed);
  if (!added.empty()) data->InsertChars(data->BufTextLen, added.c_str());
  return 0;
}

/// Draws the path field. Returns whether Enter was pressed in it.
bool draw_path_field(WindowUi& ui, FileDialog& dialog) {
  ImGui::SetNextItemWidth(-1);
  if (dialog.wants_focus) ImGui::SetKeyboardFocusHere();
  dialog.wants_focus = false;
  constexpr auto kFlags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion;
  const bool entered = ImGui::InputTextWithHint("##path", "Path or name (Tab completes it)", &dialog.path, kFlags,
                                                complete_path, &dialog);
  ui.widgets.note_item("Path");
  if (ImGui::IsItemEdited()) dialog.error.clear();  // it was about another file
  if (dialog.path != dialog.typed.text) {
    dialog.typed.text = dialog.path;
    ui.post(ListTyped{typed_path(dialog, dialog.path)});
  }
  return entered;
}

/// Draws the filter and the buttons. Returns whether the dialog's question is answered with the path. The answer is
/// disabled if `why_not` has a reason.
bool draw_filter_and_buttons(WindowUi& ui, FileDialog& dialog, const std::string& why_not) {
  ImGui::SetNextItemWidth(14 * ImGui::GetFontSize());
  ImGui::InputTextWithHint("##filter", "Filter names", &dialog.filter);
  ui.widgets.note_item("Filter");
  const float width = 6 * ImGui::GetFontSize();
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - 2 * width -
                  ImGui::GetStyle().ItemSpacing.x);
  const bool cancelled = button(ui, "Cancel", ImVec2(width, 0)) || escapes_dialog(ui);
  ImGui::SameLine();
  const bool replaces = !dialog.exists.empty() && typed_path(dialog, dialog.path) == dialog.exists;
  ImGui::BeginDisabled(!why_not.empty());
  const bool accepted = button(ui, replaces ? "Replace" : row_of(dialog.task).button, ImVec2(width, 0));
  tooltip(why_not);
  ImGui::EndDisabled();
  if (!cancelled) return accepted;
  close(dialog);
  ui.post(DialogClosed{});
  return false;
}

/// Returns the number of rows of the task's settings, above the buttons.
float setting_rows(FileTask task) {
  return task == FileTask::export_video ? kVideoSettingRows : task == FileTask::export_picture ? 1 : 0;
}

/// Draws why the folder could not be listed or the file not be written.
void draw_dialog_problem(WindowUi& ui, const std::string& problem) {
  if (problem.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(palette(ui.dark).error, "%s", problem.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item(problem);
}

void draw_file_dialog(App& app) {
  FileDialog& dialog = app.get<FileDialog>();
  WindowUi& ui = *app.ui;
  const char* const title = row_of(dialog.task).title;
  if (dialog.open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  place_dialog(52, 32);
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDocking)) return;
  ImGui::TextDisabled("%s", dialog.folder.c_str());
  ui.widgets.note_item("Folder");
  walk(dialog);
  const float rows = 2 + setting_rows(dialog.task);
  float below = rows * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  if (!dialog.error.empty())
    below += ImGui::CalcTextSize(dialog.error.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y +
             ImGui::GetStyle().ItemSpacing.y;
  draw_places(app, dialog, -below);
  ImGui::SameLine();
  draw_entries(app, dialog, -below);
  draw_dialog_problem(ui, dialog.error);
  const bool entered = draw_path_field(ui, dialog);
  if (dialog.task == FileTask::export_picture) draw_size(ui, dialog);
  std::string why_not;
  if (dialog.task == FileTask::export_video) why_not = draw_video_settings(ui, app.get<VideoState>(), dialog.path);
  const bool accepted = draw_filter_and_buttons(ui, dialog, why_not);
  if (accepted || (entered && dialog.open && why_not.empty())) accept(app, dialog);
  ImGui::EndPopup();
}

/// Duration of a load after which the progress bar appears. Shorter loads show no bar.
constexpr double kShowAfterSeconds = 0.5;

constexpr auto kCardFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_AlwaysAutoResize;

ImVec2 middle_of(const Rect& rect) {
  return {rect.center_x(), rect.center_y()};
}

void draw_unsaved_question(WindowUi& ui, const DocumentView& document, bool& asks_unsaved) {
  constexpr const char* kTitle = "Unsaved changes";
  if (asks_unsaved && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  constexpr auto kFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize;
  if (!ImGui::BeginPopupModal(kTitle, nullptr, kFlags)) return;
  ImGui::Text("%s has changes that are not saved.", document.name.c_str());
  ImGui::Spacing();
  const ImVec2 size(8 * ImGui::GetFontSize(), 0);
  std::optional<UnsavedAnswer> answer;
  if (button(ui, "Save", size)) answer = UnsavedAnswer::save;
  ImGui::SameLine();
  if (button(ui, "Discard", size)) answer = UnsavedAnswer::discard;
  ImGui::SameLine();
  if (button(ui, "Cancel", size) || escapes_dialog(ui)) answer = UnsavedAnswer::cancel;
  if (answer || !asks_unsaved) ImGui::CloseCurrentPopup();
  if (answer) {
    asks_unsaved = false;
    ui.post(AnswerUnsaved{*answer});
  }
  ImGui::EndPopup();
}

void draw_recovery_card(WindowUi& ui, Recovery& recovery) {
  constexpr const char* kTitle = "Unsaved work was kept";
  if (recovery.name.empty()) return;
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  constexpr auto kFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize;
  if (!ImGui::BeginPopupModal(kTitle, nullptr, kFlags)) return;
  ImGui::Text("%s", recovery.name.c_str());
  ImGui::TextDisabled("%s", recovery.detail.c_str());
  ImGui::Spacing();
  const ImVec2 size(9 * ImGui::GetFontSize(), 0);
  std::optional<bool> recover;
  if (button(ui, "Recover", size)) recover = true;
  ImGui::SameLine();
  if (button(ui, "Discard", size)) recover = false;
  if (recover) {
    ImGui::CloseCurrentPopup();
    recovery.name.clear();
    ui.post(AnswerRecovery{*recover});
  }
  ImGui::EndPopup();
}

}  // namespace

void draw_loading(WindowUi& ui, const ViewPlace& place, const DocumentView& document) {
  const Loading& loading = document.loading;
  if (!loading.active || loading.seconds < kShowAfterSeconds) return;
  ImGui::SetNextWindowPos(middle_of(place.rect), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  ImGui::PushStyleColor(ImGuiCol_Button, palette(ui.dark).panel);
  ImGui::Begin("Loading", nullptr, kCardFlags | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::Text("Loading %s", loading.what.c_str());
  const float width = 20 * ImGui::GetFontSize();
  // A negative fraction animates a bar of unknown length.
  const double fraction = loading.fraction > 0 ? loading.fraction : -ImGui::GetTime();
  progress_bar(ui, static_cast<float>(fraction), width);
  ImGui::TextDisabled("%s", loading.step.c_str());
  ui.widgets.note_item(loading.step);
  if (loading.can_cancel && button(ui, "Cancel loading", ImVec2(-1, 0))) ui.post(CancelLoading{});
  ImGui::End();
  ImGui::PopStyleColor(2);
}

constinit const Feature kFiles{
    .draw_card =
        [](App& app) {
          draw_loading(*app.ui, app.viewer->view, app.shown->document);
          draw_file_notices(*app.ui, app.viewer->view, app.get<FilesState>().notices);
          draw_file_dialog(app);
          draw_unsaved_question(*app.ui, app.shown->document, app.get<FilesState>().asks_unsaved);
          draw_recovery_card(*app.ui, app.get<FilesState>().recovery);
        },
    .dump = dump_files,
    .saved =
        [](App& app) {
          return std::vector<SavedValue>{{"recent", &app.get<FilesState>().recent},
                                         {"desktop_dialog", &app.get<FileDialog>().prefers_desktop}};
        },
};

namespace {

// Lengths in heights of text.
constexpr float kWidestTile = 15, kNarrowestTile = 9.5f, kTileGap = 0.7f;
constexpr const char* kTourHint = "New here? Help > Tour shows the window in five steps.";
constexpr float kRoomForTexts = 13;  // of the card's height, without pictures and recent files

/// Draws a picture with its label below, as one button.
void draw_tile(WindowUi& ui, const ExampleTile& tile, float width) {
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), height = width / tile.aspect;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(tile.label.c_str(), {width, height + 1.5f * line})) ui.post(OpenExample{tile.name});
  ui.widgets.note_item(tile.label);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(tile.tip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, to_u32(colors.field), 4);
  list.AddImageRounded(ImTextureRef(static_cast<ImTextureID>(tile.picture)), at, {at.x + width, at.y + height}, {0, 0},
                       {1, 1}, IM_COL32_WHITE, 4);
  list.AddRect(at, {at.x + width, at.y + height}, to_u32(hovered ? colors.accent : colors.dim), 4,
               hovered ? 2.0f : 1.0f);
  list.AddText({at.x, at.y + height + 0.25f * line}, to_u32(hovered ? colors.accent : colors.text), tile.label.c_str());
}

/// Returns the width of a tile: two stand in a row, and two rows fit with the texts into the view's height.
float tile_width(const ViewPlace& place, const std::vector<ExampleTile>& examples, float taken) {
  const float line = ImGui::GetFontSize();
  const float by_width = 0.5f * (place.rect.width() - 5 * line);
  const float by_height = 0.5f * (place.rect.height() - taken * line) * examples.front().aspect;
  return std::clamp(std::min(by_width, by_height), kNarrowestTile * line, kWidestTile * line);
}

/// Returns the kinds of files that can be dropped, in lines of at most `room` pixels. Each kind stays whole: ImGui
/// would break ".npz" after its dot.
std::string formats_in_lines(float room) {
  std::string text, last_line;
  const auto add = [&](std::string_view kind) {
    const std::string longer = last_line.empty() ? std::string(kind) : last_line + "  " + std::string(kind);
    const bool fits = last_line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= room;
    if (!fits) text += last_line + "\n";
    last_line = fits ? longer : std::string(kind);
  };
  for (const MeshFormat& format : kMeshFormats)
    if (can_read(format)) add(format.name);
  for (const char* kind : {".taxels.json", ".yaml", ".csv", ".urdf", ".npz", ".txt", ".taxelproj", "MuJoCo XML"})
    add(kind);
  return text + last_line;
}

void draw_invitation(WindowUi& ui, FileDialog& dialog, float room) {
  ImGui::PushFont(nullptr, 1.3f * kTextHeight);
  ImGui::TextUnformatted("Drop a mesh or a layout here");
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
  ImGui::TextUnformatted(formats_in_lines(room).c_str());
  ImGui::PopStyleColor();
  ImGui::Spacing();
  if (button(ui, "Open##start", ImVec2(9 * ImGui::GetFontSize(), 0))) open_dialog(ui, dialog);
}

}  // namespace

void draw_start_card(WindowUi& ui, const ViewPlace& place, const std::vector<ExampleTile>& examples, FileDialog& dialog,
                     const std::vector<std::string>& recent, bool shows_tour) {
  const float line = ImGui::GetFontSize();
  const std::size_t shown = std::min<std::size_t>(recent.size(), 5);
  const float taken = kRoomForTexts + (shown > 0 ? 1.6f * static_cast<float>(shown + 1) : 0) + (shows_tour ? 2 : 0);
  const float width = examples.empty() ? kWidestTile * line : tile_width(place, examples, taken);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  const float height = taken * line + (examples.empty() ? 0 : 2 * width / examples.front().aspect);
  const bool fits = height < place.rect.height();  // otherwise it covers panels below the view, not the toolbar above
  ImGui::SetNextWindowPos({place.rect.center_x(), fits ? place.rect.center_y() : place.rect.y0 + 4}, ImGuiCond_Always,
                          ImVec2(0.5f, fits ? 0.5f : 0.0f));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  ImGui::PushStyleColor(ImGuiCol_Button, palette(ui.dark).panel);  // the usual button colour equals the popup's
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(1.3f * line, 1.1f * line));
  ImGui::Begin("Start", nullptr, kFlags);
  const float room = 2 * width + kTileGap * line;
  ImGui::PushTextWrapPos(1.3f * line + room);
  draw_invitation(ui, dialog, room);
  ImGui::Spacing();
  if (!examples.empty()) ImGui::TextDisabled("Examples");
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(0, kTileGap * line);
    draw_tile(ui, examples[i], width);
  }
  if (shown > 0) {
    ImGui::Spacing();
    ImGui::TextDisabled("Recent");
    for (std::size_t i = 0; i < shown; ++i) {
      if (selectable(ui, recent[i].c_str(), false)) ui.post(OpenFile{recent[i]});
    }
  }
  if (shows_tour) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", kTourHint);
    ui.widgets.note_item(kTourHint);
  }
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

}  // namespace taxel::ui
