#include "ui/widgets/pressure_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text/rounded.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/text_fit.h"

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

constexpr float kTall = 22, kColumn = 5.8f;   // height and width of a column of the legend, in heights of text
constexpr float kLow = 15;                    // below this height the bars are next to each other, in heights of text
constexpr float kButton = 1.4f, kGap = 0.3f;  // height of a button and the gap below it, in heights of text
constexpr float kTitles = 3.0f;               // height of the name and the unit above a bar, in heights of text

/// One colour bar of the legend with its texts and its button.
struct Block {
  const char* name;   ///< name of the quantity
  const char* panel;  ///< panel of the recorded numbers
  ReadingUnit unit;
  const PressureRange* range;
  Rect rect;
  [[nodiscard]] Rect button() const {
    const float line = ImGui::GetFontSize();
    return {rect.x0 + kGap * line, rect.y1 - (kButton + kGap) * line, rect.x1 - kGap * line, rect.y1 - kGap * line};
  }
};

bool is_side_by_side(const LegendScales& scales, float height) {
  return !scales.linked && height < kLow * ImGui::GetFontSize();
}

Rect link_button(const LegendPlace& place) {
  const float line = ImGui::GetFontSize(), bottom = place.corner.y + place.height;
  return {place.corner.x - place.width + kGap * line, bottom - (kButton + kGap) * line, place.corner.x - kGap * line,
          bottom - kGap * line};
}

/// Returns the lower end of the blocks. Without buttons, it is that much below the legend as a button is high.
float bottom_of_blocks(const LegendScales& scales, const LegendPlace& place) {
  const float line = ImGui::GetFontSize();
  return scales.has_buttons ? link_button(place).y0 - kGap * line : place.corner.y + place.height + kButton * line;
}

std::vector<Block> blocks(const LegendScales& scales, const LegendPlace& place) {
  const float x0 = place.corner.x - place.width, x1 = place.corner.x, y0 = place.corner.y,
              y1 = bottom_of_blocks(scales, place);
  if (scales.linked) return {{"Pressure", "Pressure legend", {}, &scales.surface, {x0, y0, x1, y1}}};
  const bool beside = is_side_by_side(scales, place.height);
  const float x = 0.5f * (x0 + x1), y = 0.5f * (y0 + y1);
  return {{"Surface", "Pressure legend", {}, &scales.surface, {x0, y0, beside ? x : x1, beside ? y1 : y}},
          {"Readings", "Readings legend", scales.unit, &scales.readings, {beside ? x : x0, beside ? y0 : y, x1, y1}}};
}

bool place_button(Ui& ui, const char* label, const Rect& rect, const char* tooltip_text) {
  ImGui::SetCursorScreenPos({rect.x0, rect.y0});
  ImGui::PushID(label);
  const bool clicked = ImGui::InvisibleButton("##legend", {rect.width(), rect.height()});
  ImGui::PopID();
  ui.widgets.note_item(label);
  tooltip(tooltip_text);
  return clicked;
}

void draw_button(const Ui& ui, ImDrawList& list, const Rect& button, const char* text, const ImVec4& ink) {
  const Palette& colors = palette(ui.dark);
  const bool hovered = ImGui::IsMouseHoveringRect({button.x0, button.y0}, {button.x1, button.y1});
  list.AddRectFilled({button.x0, button.y0}, {button.x1, button.y1}, to_u32(hovered ? colors.accent : colors.raised),
                     ImGui::GetStyle().FrameRounding);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 size = ImGui::CalcTextSize(text);
  list.AddText({std::round(button.center_x() - 0.5f * size.x), std::round(button.center_y() - 0.5f * size.y)},
               to_u32(hovered ? text_on(colors.accent) : ink), text);
  ImGui::PopFont();
}

/// Draws a text and records it as a widget.
void draw_text(Ui& ui, ImDrawList& list, const char* panel, ImVec2 at, const ImVec4& color, const std::string& text) {
  list.AddText(at, to_u32(color), text.c_str());
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ui.widgets.note(panel, text, {at.x, at.y, at.x + size.x, at.y + size.y});
}

void draw_block(Ui& ui, ImDrawList& list, const Block& block, bool has_button) {
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line;
  const Rect& r = block.rect;
  draw_text(ui, list, "Legend", {r.x0 + pad, r.y0 + 0.35f * line}, colors.text, block.name);
  draw_text(ui, list, "Legend", {r.x0 + pad, r.y0 + 1.4f * line}, colors.dim, block.unit.text);
  const ImVec2 lo(r.x0 + pad, r.y0 + kTitles * line), hi(r.x0 + pad + line, block.button().y0 - 0.8f * line);
  draw_color_bar(*block.range->colors, list, lo, hi);
  list.AddRect({lo.x - 1, lo.y - 1}, {hi.x + 1, hi.y + 1}, to_u32(colors.dim));
  const int ticks = tick_count(hi.y - lo.y, line);
  const std::vector<std::string> texts = legend_texts(*block.range, ticks, block.unit);
  for (int i = 0; i <= ticks; ++i) {
    const float y = hi.y + (lo.y - hi.y) * static_cast<float>(i) / static_cast<float>(ticks);
    list.AddLineH(hi.x, hi.x + 0.3f * line, std::floor(y), to_u32(colors.dim));
    draw_text(ui, list, block.panel, {hi.x + 0.5f * line, std::round(y - 0.5f * line)}, colors.text,
              texts[static_cast<std::size_t>(i)]);
  }
  if (!has_button) return;
  const bool automatic = block.range->automatic;
  draw_button(ui, list, block.button(), automatic ? "Auto range" : "Fixed range",
              automatic ? colors.text : colors.warning);
}

}  // namespace

ImU32 pressure_color(const PressureRange& range, double pressure, float alpha) {
  const glm::vec3 c = range.color(pressure);
  return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, alpha));
}

ImU32 taxel_color_u32(int number, float alpha) {
  const glm::vec3 c = taxel_color(number);
  return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, alpha));
}

ImVec2 legend_size(const LegendScales& scales, ImVec2 room) {
  const float line = ImGui::GetFontSize(), height = std::min(kTall * line, room.y);
  return {(is_side_by_side(scales, height) ? 2 : 1) * kColumn * line, height};
}

LegendClicks place_legend_buttons(Ui& ui, const LegendScales& scales, const LegendPlace& place) {
  LegendClicks clicks;
  const std::vector<Block> parts = blocks(scales, place);
  clicks.surface = place_button(
      ui, "Range", parts[0].button(),
      scales.surface.automatic ? "The range follows the largest pressure of the run. Click to keep it as it is."
                               : "The range stays as it is. Click to let it follow the largest pressure of the run.");
  if (parts.size() > 1)
    clicks.readings = place_button(
        ui, "Readings range", parts[1].button(),
        scales.readings.automatic ? "The range follows the largest reading of the run. Click to keep it as it is."
                                  : "The range stays as it is. Click to let it follow the largest reading of the run.");
  const std::string refusal =
      fmt::format("Readings in {} and pressures in kPa have no common range.", scales.unit.text);
  clicks.link = place_button(ui, "Link ranges", link_button(place),
                             !scales.unit.pressure ? refusal.c_str()
                             : scales.linked       ? "Surface and readings share one range. Click to give each its own."
                                             : "Surface and readings have a range each. Click to give both one range.");
  clicks.link = clicks.link && scales.unit.pressure;
  return clicks;
}

std::vector<std::string> legend_texts(const PressureRange& range, int ticks, const ReadingUnit& unit) {
  std::vector<std::string> texts;
  for (int i = 0; i <= ticks; ++i)
    texts.push_back(rounded(unit.scale * (range.lo + (range.hi - range.lo) * i / ticks), 4, 8));
  return texts;
}

void draw_pressure_legend(Ui& ui, const LegendScales& scales, const LegendPlace& place) {
  const Palette& colors = palette(ui.dark);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({place.corner.x - place.width, place.corner.y}, {place.corner.x, place.corner.y + place.height},
                     to_u32(colors.panel, 0.94f), ImGui::GetStyle().FrameRounding);
  for (const Block& block : blocks(scales, place)) draw_block(ui, list, block, scales.has_buttons);
  if (!scales.has_buttons) return;
  draw_button(ui, list, link_button(place), scales.linked ? "One range" : "Two ranges",
              scales.unit.pressure ? colors.text : colors.dim);
}

void draw_color_scale(const Ui& ui, const PressureRange& range, const ReadingUnit& unit, float row) {
  constexpr int kBands = 32;
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), width = 7 * line, height = 0.6f * line;
  const std::string lo = fmt::format("{:.3g}", unit.scale * range.lo),
                    hi = fmt::format("{:.3g} {}", unit.scale * range.hi, unit.text);
  const float all = small_width(lo) + width + small_width(hi) + line;
  if (ImGui::GetContentRegionAvail().x < all) return ImGui::NewLine();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float text_y = at.y + 0.5f * (row - kSmallText * line);
  const float x = at.x + small_width(lo) + 0.4f * line, y = at.y + 0.5f * (row - height);
  std::vector<TextShown> texts;
  draw_small_text(list, {at.x, text_y}, to_u32(colors.dim), lo, texts);
  for (int i = 0; i < kBands; ++i) {
    const double middle = range.lo + (range.hi - range.lo) * (i + 0.5) / kBands;
    list.AddRectFilled({x + width * static_cast<float>(i) / kBands, y},
                       {x + width * static_cast<float>(i + 1) / kBands, y + height}, pressure_color(range, middle));
  }
  draw_small_text(list, {x + width + 0.4f * line, text_y}, to_u32(colors.dim), hi, texts);
  ImGui::Dummy(ImVec2(all, row));
}

}  // namespace taxel::ui
