#include "app/studio/nouns/files/file_notices.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

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

}  // namespace

void draw_file_notices(WindowUi& ui, const ViewPlace& place, const std::vector<FileNotice>& notices) {
  const float em = ImGui::GetFontSize();
  const Rect& view = place.rect;
  const float width = std::min(36 * em, view.x1 - view.x0 - 2 * em);
  ImVec2 top(view.center_x(), view.y0 + 3 * em);
  for (const FileNotice& notice : notices) top.y += draw_notice(ui, notice, top, width) + 0.5f * em;
}

}  // namespace taxel::ui
