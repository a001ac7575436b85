#include "ui/widgets/pressure_legend.h"

#include <fmt/format.h>

#include <cmath>

#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

void draw_color_bar(const ColorMap& map, ImDrawList& list, ImVec2 lo, ImVec2 hi) {
  constexpr int kBands = 64;
  const auto color_at = [&](double t) {
    const glm::vec3 c = map.at(t);
    return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, 1));
  };
  for (int i = 0; i < kBands; ++i) {
    const double t0 = static_cast<double>(i) / kBands, t1 = static_cast<double>(i + 1) / kBands;
    const auto y = [&](double t) { return hi.y + (lo.y - hi.y) * static_cast<float>(t); };
    const ImU32 top = color_at(t1), bottom = color_at(t0);
    list.AddRectFilledMultiColor({lo.x, y(t1)}, {hi.x, y(t0)}, top, top, bottom, bottom);
  }
}

Rect range_button(const LegendPlace& place) {
  const float line = ImGui::GetFontSize(), bottom = place.corner.y + place.height;
  return {place.corner.x - pressure_legend_width() + 0.3f * line, bottom - 1.7f * line, place.corner.x - 0.3f * line,
          bottom - 0.3f * line};
}

void draw_range_state(const Ui& ui, const PressureRange& range, ImDrawList& list, const Rect& button) {
  const Palette& colors = palette(ui.dark);
  const char* state = range.automatic ? "AUTO" : "LOCKED";
  const bool hovered = ImGui::IsMouseHoveringRect({button.x0, button.y0}, {button.x1, button.y1});
  list.AddRectFilled({button.x0, button.y0}, {button.x1, button.y1}, to_u32(hovered ? colors.accent : colors.raised),
                     ImGui::GetStyle().FrameRounding);
  const ImVec2 size = ImGui::CalcTextSize(state);
  list.AddText({std::round(button.center_x() - 0.5f * size.x), std::round(button.center_y() - 0.5f * size.y)},
               to_u32(range.automatic ? colors.text : colors.warning), state);
}

}  // namespace

float pressure_legend_width() {
  return 5.6f * ImGui::GetFontSize();
}

ImU32 pressure_color(const PressureRange& range, double pressure, float alpha) {
  const glm::vec3 c = range.color(pressure);
  return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, alpha));
}

ImU32 taxel_color_u32(int number, float alpha) {
  const glm::vec3 c = taxel_color(number);
  return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, alpha));
}

void place_range_button(Ui& ui, PressureRange& range, const LegendPlace& place) {
  const Rect button = range_button(place);
  ImGui::SetCursorScreenPos({button.x0, button.y0});
  if (ImGui::InvisibleButton("##range", {button.width(), button.height()})) range.automatic = !range.automatic;
  ui.widgets.note_item("Range");
  tooltip(range.automatic ? "The range follows the largest pressure of the run. Click to lock it."
                          : "The range is locked. Click to let it follow the largest pressure.");
}

std::vector<std::string> legend_texts(const PressureRange& range, int ticks) {
  std::vector<std::string> texts;
  for (int i = 0; i <= ticks; ++i)
    texts.push_back(fmt::format("{:.4g}", 1e-3 * (range.lo + (range.hi - range.lo) * i / ticks)));
  return texts;
}

void draw_pressure_legend(Ui& ui, const PressureRange& range, const LegendPlace& place) {
  const Palette& colors = palette(ui.dark);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetFontSize(), pad = 0.5f * line;
  const ImVec2 lo(place.corner.x - pressure_legend_width(), place.corner.y),
      hi(place.corner.x, place.corner.y + place.height);
  list.AddRectFilled(lo, hi, to_u32(colors.panel, 0.82f), ImGui::GetStyle().FrameRounding);
  list.AddText({lo.x + pad, lo.y + 0.35f * line}, to_u32(colors.text), "Pressure");
  list.AddText({lo.x + pad, lo.y + 1.4f * line}, to_u32(colors.dim), "kPa");
  const ImVec2 bar_lo(lo.x + pad, lo.y + 3.0f * line), bar_hi(lo.x + pad + 1.0f * line, hi.y - 2.5f * line);
  draw_color_bar(*range.colors, list, bar_lo, bar_hi);
  const int ticks = tick_count(bar_hi.y - bar_lo.y, line);
  const std::vector<std::string> texts = legend_texts(range, ticks);
  for (int i = 0; i <= ticks; ++i) {
    const float y = bar_hi.y + (bar_lo.y - bar_hi.y) * static_cast<float>(i) / static_cast<float>(ticks);
    list.AddLineH(bar_hi.x, bar_hi.x + 0.3f * line, std::floor(y), to_u32(colors.dim));
    const ImVec2 at(bar_hi.x + 0.5f * line, std::round(y - 0.5f * line));
    const std::string& text = texts[static_cast<std::size_t>(i)];
    list.AddText(at, to_u32(colors.text), text.c_str());
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ui.widgets.note("Pressure legend", text, {at.x, at.y, at.x + size.x, at.y + size.y});
  }
  draw_range_state(ui, range, list, range_button(place));
}

}  // namespace taxel::ui
