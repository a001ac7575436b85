#include "app/studio/nouns/messages/messages.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr double kNoteSeconds = 6;

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

/// Whether a message leaves the line by itself after a while.
bool is_timed(const Message& message) {
  return message.severity == Severity::note && message.holds == Holds::always;
}

/// Closes notes that were displayed long enough. Returns the newest open message, or null, and counts them.
Message* newest_open(Messages& messages, int& count) {
  Message* newest = nullptr;
  for (Message& message : messages) {
    if (is_timed(message) && ImGui::GetTime() - message.shown_at > kNoteSeconds) message.toast = false;
    if (!message.toast) continue;
    newest = &message;
    ++count;
  }
  return newest;
}

/// Draws the text of a message in one line of a width. A text that does not fit ends with "...".
void draw_text(WindowUi& ui, PanelsShown& panels, const std::string& text, float width) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  const ImVec2 at = ImGui::GetCursorScreenPos(), size(width, ImGui::GetFrameHeight());
  if (ImGui::InvisibleButton("##text", size)) panels[kMessages] = true;
  ui.widgets.note_item(text);
  if (ImGui::IsItemHovered()) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(40 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  const float y = at.y + ImGui::GetStyle().FramePadding.y;
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), {at.x, y}, {at.x + width, at.y + size.y}, at.x + width,
                            line.c_str(), nullptr, nullptr);
}

/// Draws the contents of the line. Returns true if all messages are to be closed.
bool draw_line(WindowUi& ui, PanelsShown& panels, Message& message, int count) {
  const float padding = 2 * ImGui::GetStyle().FramePadding.x;
  const auto width_of = [&](const std::string& label) { return ImGui::CalcTextSize(label.c_str()).x + padding; };
  const std::string more = count > 1 ? fmt::format("{} more", count - 1) : "";
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(severity_color(palette(ui.dark), message.severity), "%s", name_of(message.severity));
  ImGui::SameLine(0, 8);
  float buttons = width_of("Copy") + width_of("Close") + 12;
  if (count > 1) buttons += width_of("Close all") + width_of(more) + 12;
  draw_text(ui, panels, message.text, std::max(1.0f, ImGui::GetContentRegionAvail().x - buttons));
  const auto next_button = [&](const char* label) {
    ImGui::SameLine(0, 6);
    return button(ui, label);
  };
  if (count > 1 && next_button(more.c_str())) panels[kMessages] = true;
  if (next_button("Copy")) copy_text(message.text);
  if (next_button("Close")) message.toast = false;
  return count > 1 && next_button("Close all");
}

void draw_message_line(WindowUi& ui, PanelsShown& panels, Messages& messages) {
  int count = 0;
  Message* newest = newest_open(messages, count);
  if (newest == nullptr) return;
  constexpr ImVec2 kPadding(10, 3);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, kPadding);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(6, 2));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNavInputs |
                          ImGuiWindowFlags_NoFocusOnAppearing;
  bool close_all = false;
  if (ImGui::BeginViewportSideBar("Message", ImGui::GetMainViewport(), ImGuiDir_Down,
                                  ImGui::GetFrameHeight() + 2 * kPadding.y, kFlags))
    close_all = draw_line(ui, panels, *newest, count);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (!close_all) return;
  for (Message& message : messages) message.toast = false;
}

void draw_messages_panel(WindowUi& ui, PanelsShown& panels, Messages& messages) {
  if (begin_panel(ui, kMessages.title, &panels[kMessages])) {
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

}  // namespace

bool toasts_will_change(const Messages& messages) {
  return std::any_of(messages.begin(), messages.end(), [](const Message& m) { return m.toast && is_timed(m); });
}

constinit const Feature kMessages{
    .title = "Messages",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .key = "panel_messages",
    .label = "Messages",
    .draw = [](App& app) { draw_messages_panel(*app.ui, app.get<PanelsShown>(), app.get<Messages>()); },
    .guide = "Open a file",
    .dump = dump_messages,
};

constinit const Feature kMessageLine{
    .draw_bar =
        [](App& app) {
          if (!app.get<WindowParts>().is_presenting)
            draw_message_line(*app.ui, app.get<PanelsShown>(), app.get<Messages>());
        },
};

}  // namespace taxel::ui
