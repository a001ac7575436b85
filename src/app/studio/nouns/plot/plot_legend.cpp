#include "app/studio/nouns/plot/plot_legend.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/curve_colors.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr float kLegendSwatch = 1.9f, kLegendGap = 0.4f;  // in heights of text

/// Draws a piece of the curve: a line, or dashes over a grey line if the curve lies on another one.
void draw_swatch_line(const WindowUi& ui, const ChosenCurve& curve, const CurveStyle& style, ImVec2 from, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  const ImU32 color = to_u32(curve_color(curve.color, ui.dark), style.dimmed ? kDimmedAlpha : 1.0f);
  const auto scale = static_cast<float>(ui.pixel_scale);
  const float weight = std::min(4.0f, static_cast<float>(style.width)) * scale;
  if (!style.dashes) return list.AddLine(from, {from.x + width, from.y}, color, weight);
  list.AddLine(from, {from.x + width, from.y}, to_u32(colors.line), weight);
  const float dash = width / 5;
  for (float x = 0; x < width; x += 2 * dash)
    list.AddLine({from.x + x, from.y}, {from.x + x + dash, from.y}, color, weight);
}

/// Draws a triangle that marks the taxel at which the simulation stopped.
void draw_stop_mark(const WindowUi& ui, ImVec2 center, float r) {
  ImGui::GetWindowDrawList()->AddTriangleFilled({center.x, center.y - r}, {center.x + r, center.y + 0.8f * r},
                                                {center.x - r, center.y + 0.8f * r}, to_u32(palette(ui.dark).warning));
}

}  // namespace

std::string legend_tip(const ChosenCurve& curve) {
  std::string tip = "Taxel " + curve.label;
  if (curve.jumped) tip += "\nThe simulation stopped at this taxel.";
  if (curve.of > 1) tip += fmt::format("\nIts curve lies on {} other{}.", curve.of - 1, curve.of > 2 ? "s" : "");
  return tip + "\nClick: keep the other curves dim, and select the taxel. Shift adds.";
}

float plot_legend_width(const std::vector<ChosenCurve>& curves) {
  float widest = 0;
  for (const ChosenCurve& curve : curves) widest = std::max(widest, ImGui::CalcTextSize(curve.label.c_str()).x);
  const float line = ImGui::GetFontSize();
  return widest + (kLegendSwatch + 3 * kLegendGap + 0.8f) * line + ImGui::GetStyle().ScrollbarSize;
}

LegendPointer draw_plot_legend(WindowUi& ui, const std::vector<ChosenCurve>& curves, std::vector<TaxelKey>& isolated,
                               ImVec2 size, const std::function<std::string(const ChosenCurve&)>& tip) {
  LegendPointer pointer;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginChild("##legend", size)) {
    const float line = ImGui::GetFontSize(), row = ImGui::GetTextLineHeight() + 2;
    const std::vector<TaxelKey> focus = focus_of(curves, std::nullopt, isolated);
    for (const ChosenCurve& curve : curves) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const std::string id = fmt::format("##curve {} {}", curve.key.sensor, curve.key.id);
      const bool kept = std::find(isolated.begin(), isolated.end(), curve.key) != isolated.end();
      if (ImGui::Selectable(id.c_str(), kept || curve.selected, 0, ImVec2(0, row))) {
        click_isolated(isolated, curve.key, ImGui::GetIO().KeyShift);
        if (!kept) pointer.clicked = curve.key;
      }
      if (ImGui::IsItemHovered()) pointer.hovered = curve.key;
      ui.widgets.note_item("Curve " + curve.label);
      const CurveStyle style = style_of(curve, focus);
      const float middle = std::round(at.y + 0.5f * row), text_x = at.x + (kLegendSwatch + 2 * kLegendGap) * line;
      draw_swatch_line(ui, curve, style, {at.x + kLegendGap * line, middle}, kLegendSwatch * line);
      ImGui::GetWindowDrawList()->AddText(
          {text_x, at.y + 1}, to_u32(style.dimmed ? palette(ui.dark).dim : palette(ui.dark).text), curve.label.c_str());
      if (curve.jumped)
        draw_stop_mark(ui, {text_x + ImGui::CalcTextSize(curve.label.c_str()).x + 0.6f * line, middle}, 0.35f * line);
      tooltip(tip(curve));
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  return pointer;
}

}  // namespace taxel::ui
