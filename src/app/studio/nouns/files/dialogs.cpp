#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_notices.h"
#include "app/studio/nouns/files/files.h"
#include "app/studio/nouns/files/kept_documents.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/video/video_state.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

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
  if (button(ui, "Cancel", size) || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) answer = UnsavedAnswer::cancel;
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
  ImGui::ProgressBar(
      loading.fraction > 0 ? static_cast<float>(loading.fraction) : -static_cast<float>(ImGui::GetTime()),
      ImVec2(width, 0), loading.fraction > 0 ? nullptr : "");
  ui.widgets.note_item("Progress");
  if (loading.can_cancel) {
    if (button(ui, "Cancel loading", ImVec2(-1, 0))) ui.post(CancelLoading{});
  } else {
    ImGui::TextDisabled("Building the scene");
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
}

constinit const Feature kFiles{
    .draw_card =
        [](App& app) {
          draw_loading(*app.ui, app.viewer->view, app.shown->document);
          draw_file_notices(*app.ui, app.viewer->view, app.get<FilesState>().notices);
          draw_file_dialog(*app.ui, app.get<ControlsState>(), app.get<VideoState>(), app.get<FileDialog>());
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

}  // namespace taxel::ui
