#include "ui/panels/scene_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "ui/panels/tool_overlay.h"
#include "ui/scene/gizmo.h"
#include "ui/scene/scene_places.h"
#include "ui/theme.h"
#include "ui/tools/camera_follow.h"
#include "ui/tools/scene_info.h"

namespace taxel::ui {

namespace {

constexpr float kRowHeight = 1.3f, kPadding = 0.5f;  // in heights of text

/// "Frames: sites", with a word where there are none.
std::string marks_text(const UiState& ui) {
  const Overlays& overlays = ui.saved.overlays;
  std::string text;
  if (overlays.frames != FramesShown::none) {
    text = fmt::format("Frames: {}{}", to_word(overlays.frames), shown_frames(ui.view.input).empty() ? " (none)" : "");
  }
  if (overlays.labels != LabelsShown::none) {
    text += fmt::format("{}Labels: {}{}", text.empty() ? "" : "   ", to_word(overlays.labels),
                        labelled_places(ui.view.input).empty() ? " (none)" : "");
  }
  return text;
}

std::string body_text(const UiState& ui, const UiInput& input) {
  const std::vector<SceneBody>& bodies = input.frame->scene->controls.bodies;
  const auto body = static_cast<std::size_t>(ui.selection.body);
  return ui.selection.body >= 0 && body < bodies.size() ? "Body: " + bodies[body].name : "";
}

/// Upper edge of the gizmo [pixels of the window].
float gizmo_top(const UiState& ui) {
  const double height = kGizmoMargin + 2 * (kGizmoReach + kGizmoBallRadius);
  return ui.view.rect.y1 - static_cast<float>(height * ui.pixel_scale);
}

/// Names and values, in as many columns as there must be for the gizmo to stay free.
void draw_info(UiState& ui, const UiInput& input, float top) {
  const std::vector<InfoRow> rows = scene_info(input);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize(), step = kRowHeight * line, pad = kPadding * line;
  const float height = gizmo_top(ui) - top;
  const auto fitting = static_cast<std::size_t>(std::max(1.0f, (height - 2 * pad) / step));
  const std::size_t columns = (rows.size() + fitting - 1) / fitting, per = (rows.size() + columns - 1) / columns;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.saved.dark);
  const auto wide = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  float x = ui.view.rect.x0 + line;
  for (std::size_t first = 0; first < rows.size(); first += per) {
    const std::size_t end = std::min(rows.size(), first + per);
    float name = 0, value = 0;
    for (std::size_t i = first; i < end; ++i) {
      name = std::max(name, wide(rows[i].name));
      value = std::max(value, wide(rows[i].value));
    }
    const float width = name + line + value, bottom = top + 2 * pad + step * static_cast<float>(end - first);
    list.AddRectFilled({x - pad, top}, {x + width + pad, bottom}, to_u32(colors.panel, 0.88f), 3);
    for (std::size_t i = first; i < end; ++i) {
      const float y = top + pad + step * static_cast<float>(i - first);
      list.AddText({x, y}, to_u32(colors.dim), rows[i].name.c_str());
      list.AddText({x + name + line, y}, to_u32(colors.text), rows[i].value.c_str());
    }
    x += width + 2 * pad + 0.3f * line;
  }
  ImGui::PopFont();
}

}  // namespace

void draw_scene_overlay(UiState& ui, const UiInput& input, int row) {
  if (ui.mode != Mode::simulate || !input.frame || !input.frame->scene) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.saved.dark);
  for (const std::string& text : {follow_text(ui, input), body_text(ui, input), marks_text(ui)})
    if (!text.empty()) draw_view_line(ui, list, row++, text, colors.text);
  if (ui.saved.panels.info) draw_info(ui, input, view_line_top(ui, row));
}

}  // namespace taxel::ui
