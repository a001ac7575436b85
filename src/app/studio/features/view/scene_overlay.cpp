#include "app/studio/features/view/scene_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/view/scene_info.h"
#include "app/studio/features/view/tool_overlay.h"
#include "ui/scene/scene_places.h"
#include "ui/theme.h"

namespace taxel::ui {

namespace {

constexpr float kWideView = 36;  // in heights of text: room for two texts beside each other
constexpr float kBackground = 0.88f;

/// "sites", with a word where there are none.
std::string kind_text(const char* kind, bool none) {
  return none ? fmt::format("{} (none)", kind) : kind;
}

std::string frames_text(const UiState& ui) {
  const FramesShown frames = ui.saved.overlays.frames;
  return frames == FramesShown::none ? ""
                                     : "Frames: " + kind_text(to_word(frames), shown_frames(ui.view.input).empty());
}

std::string labels_text(const UiState& ui) {
  const LabelsShown labels = ui.saved.overlays.labels;
  return labels == LabelsShown::none ? ""
                                     : "Labels: " + kind_text(to_word(labels), labelled_places(ui.view.input).empty());
}

std::string body_text(const UiState& ui, const UiInput& input) {
  const std::vector<SceneBody>& bodies = input.frame->scene->controls.bodies;
  const auto body = static_cast<std::size_t>(ui.selection.body);
  return ui.selection.body >= 0 && body < bodies.size() ? "Body: " + bodies[body].name : "";
}

/// Room that a row takes where its value wraps at `width`.
float height_of(const InfoRow& row, float width) {
  return ImGui::CalcTextSize(row.value.c_str(), nullptr, false, width).y + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

int draw_scene_overlay(const UiState& ui, const UiInput& input, int row) {
  if (ui.mode != Mode::simulate || !input.frame || !input.frame->scene) return row;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  std::string frames = frames_text(ui), labels = labels_text(ui);
  if (ui.view.rect.width() > kWideView * ImGui::GetFontSize() && !frames.empty() && !labels.empty())
    frames += "   " + std::exchange(labels, "");
  for (const std::string& text : {follow_text(ui, input), body_text(ui, input), frames, labels})
    if (!text.empty()) draw_view_line(ui, list, row++, text, colors.text);
  return row;
}

void draw_info_card(UiState& ui, const UiInput& input, int row) {
  if (!ui.saved.panels.info || ui.mode != Mode::simulate) return;
  const std::vector<InfoRow> rows = scene_info(input);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, margin = 0.6f * line;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0.25f * line});
  float name = 0, value = 0, height = 2 * pad;
  for (const InfoRow& r : rows) {
    name = std::max(name, ImGui::CalcTextSize(r.name.c_str()).x);
    value = std::max(value, ImGui::CalcTextSize(r.value.c_str()).x);
  }
  name += line;
  value = std::min(value + 1, ui.view.rect.width() - name - 2 * (pad + margin) - ImGui::GetStyle().ScrollbarSize);
  for (const InfoRow& r : rows) height += height_of(r, value);
  const float top = view_line_top(ui, row) + 0.2f * line, room = ui.view.rect.y1 - margin - top;
  const bool scrolls = height > room;
  ImGui::SetNextWindowPos({ui.view.rect.x0 + margin, top});
  ImGui::SetNextWindowSize(
      {name + value + 2 * pad + (scrolls ? ImGui::GetStyle().ScrollbarSize : 0), std::min(height, room)});
  ImGui::SetNextWindowBgAlpha(kBackground);
  constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  if (ImGui::Begin("Info", nullptr, scrolls ? kFlags : kFlags | ImGuiWindowFlags_NoInputs)) {
    ui.widgets.note_item("Info");
    for (const InfoRow& r : rows) {
      ImGui::TextDisabled("%s", r.name.c_str());
      ImGui::SameLine(pad + name);
      ImGui::PushTextWrapPos(pad + name + value);
      ImGui::TextUnformatted(r.value.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace taxel::ui
