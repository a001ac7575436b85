#include "app/studio/features/messages/messages.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/studio/app/panel_spec.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr double kNoteSeconds = 6;
constexpr int kMostToasts = 4;

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "Error";
    case Severity::warning:
      return "Warning";
    case Severity::note:
      break;
  }
  return "Note";
}

void copy_text(const std::string& text) {
  ImGui::SetClipboardText(text.c_str());
}

/// One floating message with its lower right corner at `corner`. Returns its height.
float draw_toast(WindowUi& ui, Message& message, ImVec2 corner) {
  const Palette& colors = palette(ui.dark);
  const float width = std::min(30 * ImGui::GetFontSize(), corner.x - 12);
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, ImVec2(1, 1));
  ImGui::SetNextWindowSize(ImVec2(width, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, severity_color(colors, message.severity));
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                          ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin(fmt::format("Message##toast{}", message.number).c_str(), nullptr, kFlags);
  ImGui::TextColored(severity_color(colors, message.severity), "%s", name_of(message.severity));
  const float buttons = ImGui::CalcTextSize("CopyClose").x + 4 * ImGui::GetStyle().FramePadding.x + 6;
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - buttons);
  if (ImGui::SmallButton("Copy")) copy_text(message.text);
  ui.widgets.note_item("Copy");
  ImGui::SameLine(0, 6);
  if (ImGui::SmallButton("Close")) message.toast = false;
  ui.widgets.note_item("Close");
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item(message.text);
  const float height = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleColor(2);
  return height;
}

}  // namespace

void draw_toasts(WindowUi& ui, const ViewPlace& place, Messages& messages) {
  const double now = ImGui::GetTime();
  const Rect& view = place.rect;
  ImVec2 corner(view.x1 - 12, view.y1 - 12);
  int shown = 0;
  for (auto it = messages.rbegin(); it != messages.rend() && shown < kMostToasts; ++it) {
    if (it->severity == Severity::note && now - it->shown_at > kNoteSeconds) it->toast = false;
    if (!it->toast) continue;
    corner.y -= draw_toast(ui, *it, corner) + 8;
    ++shown;
  }
}

bool toasts_will_change(const Messages& messages) {
  return std::any_of(messages.begin(), messages.end(),
                     [](const Message& m) { return m.toast && m.severity == Severity::note; });
}

void draw_messages_panel(WindowUi& ui, PanelsShown& panels, Messages& messages) {
  if (begin_panel(ui, kMessagesTitle, &panels.messages)) {
    if (button(ui, "Copy all")) {
      std::string all;
      for (const Message& m : messages) all += fmt::format("{}: {}\n", name_of(m.severity), m.text);
      copy_text(all);
    }
    ImGui::SameLine();
    if (button(ui, "Clear")) messages.clear();
    if (ImGui::BeginChild("list")) {
      const Palette& colors = palette(ui.dark);
      ImGui::PushTextWrapPos(0);
      for (const Message& m : messages) {
        ImGui::TextColored(severity_color(colors, m.severity), "%s", name_of(m.severity));
        ImGui::SameLine();
        ImGui::TextUnformatted(m.text.c_str());
      }
      ImGui::PopTextWrapPos();
    }
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace taxel::ui
