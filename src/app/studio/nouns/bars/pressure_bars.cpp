#include "app/studio/nouns/bars/pressure_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

std::vector<BarSpan> place_groups(std::span<const std::size_t> counts, float x0, float x1, float gap) {
  std::vector<BarSpan> spans;
  const std::size_t columns = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (columns == 0) return spans;
  const auto gaps = static_cast<float>(counts.size() - 1);
  const float between = gaps > 0 ? std::min(gap, (x1 - x0) / (3 * gaps)) : 0.0f;
  const float step = (x1 - x0 - gaps * between) / static_cast<float>(columns);
  float at = x0;
  for (const std::size_t count : counts) {
    spans.push_back({at, at + static_cast<float>(count) * step, step});
    at = spans.back().x1 + between;
  }
  return spans;
}

namespace {

/// The position of the vertical axis, in pixels, with its range and unit.
struct Axis {
  float x0, x1, y_zero, y_top;
  double top;  ///< value at the upper end of the axis, in SI units
  ReadingUnit unit;
  [[nodiscard]] float y(double pressure) const {
    return y_zero - static_cast<float>(std::clamp(pressure / top, 0.0, 1.0)) * (y_zero - y_top);
  }
};

void small_text(ImDrawList& list, ImVec2 pos, ImU32 color, const std::string& text) {
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize() * kSmallText, pos, color, text.c_str());
}

float small_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x * kSmallText;
}

/// Draws lines and values of the axis; the uppermost value has the unit if `with_unit`.
void draw_axis(ImDrawList& list, const Axis& axis, const Palette& colors, bool with_unit) {
  const int ticks = tick_count(axis.y_zero - axis.y_top, kSmallText * ImGui::GetFontSize());
  for (int i = 0; i <= ticks; ++i) {
    const double value = axis.top * i / ticks;
    const float y = std::floor(axis.y(value));
    list.AddLineH(axis.x0, axis.x1, y, to_u32(i == 0 ? colors.dim : colors.line));
    const std::string unit = with_unit && i == ticks ? fmt::format(" {}", axis.unit.text) : "";
    const std::string text = fmt::format("{:.3g}{}", axis.unit.scale * value, unit);
    small_text(list, {axis.x0 - small_width(text) - 5, y - 0.5f * kSmallText * ImGui::GetFontSize()},
               to_u32(colors.dim), text);
  }
}

ImVec4 as_imvec(const glm::vec3& c) {
  return {c.x, c.y, c.z, 1};
}

/// Draws a rectangle in the colour of a taxel. If the colour is hard to see on the background, a wide rectangle gets an
/// outline, and a narrow one a lighter or darker shade of the colour. Returns whether there is an outline.
bool draw_in_taxel_color(ImDrawList& list, const Rect& rect, const glm::vec3& color, const Palette& colors) {
  constexpr float kNarrow = 5;  // [pixel]
  const glm::vec3 background(colors.field.x, colors.field.y, colors.field.z);
  const bool wide = rect.width() >= kNarrow, outlined = wide && needs_outline(color, background);
  const glm::vec3 shade = wide ? color : with_contrast(color, background, kGraphicsContrast);
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(as_imvec(shade)));
  if (outlined) list.AddRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(colors.dim));
  return outlined;
}

/// Draws the error bar of a reading, in the middle of its bar, dark on light and light on dark.
void draw_whisker(ImDrawList& list, const Axis& axis, const BarValue& bar, float left, float right,
                  const Palette& colors) {
  const float x = std::floor(0.5f * (left + right)), half = std::min(4.0f, 0.35f * (right - left));
  const float lo = axis.y(bar.value - bar.error), hi = axis.y(bar.value + bar.error);
  for (const auto& [color, wide] : {std::pair(colors.field, 3.0f), std::pair(colors.text, 1.0f)}) {
    list.AddLine({x, lo}, {x, hi}, to_u32(color), wide);
    list.AddLineH(x - half, x + half, lo, to_u32(color), wide);
    list.AddLineH(x - half, x + half, hi, to_u32(color), wide);
  }
}

/// Draws one bar within its column of the axis, from x0 to x1.
void draw_bar(WindowUi& ui, BarsShown& bars, ImDrawList& list, const Axis& axis, float x0, float x1,
              const BarValue& bar, bool selected) {
  const Palette& colors = palette(ui.dark);
  const float gap = 0.14f * (x1 - x0), left = std::round(x0 + gap), right = std::max(left + 1, std::round(x1 - gap));
  if (selected) list.AddRectFilled({x0, axis.y_top - 4}, {x1, axis.y_zero}, to_u32(colors.accent, 0.16f), 3);
  list.AddRectFilled({left, axis.y_top}, {right, axis.y_zero}, to_u32(colors.field));
  const float y = axis.y(bar.value);
  BarShown shown;
  shown.taxel_id = bar.id;
  shown.value = bar.value;
  shown.height = static_cast<double>(axis.y_zero - y);
  shown.rect = {left, y, right, axis.y_zero};
  shown.top = axis.top;
  shown.axis_height = static_cast<double>(axis.y_zero - axis.y_top);
  shown.color = taxel_color(bar.color);
  shown.over = bar.value > axis.top;
  if (y < axis.y_zero) shown.outlined = draw_in_taxel_color(list, shown.rect, shown.color, colors);
  shown.error = bar.error;
  if (bar.error > 0) draw_whisker(list, axis, bar, left, right, colors);
  if (bar.peak > 0) list.AddLineH(left, right, axis.y(bar.peak), to_u32(colors.text), 1.5f);
  if (shown.over) {
    const float middle = 0.5f * (left + right), half = std::min(4.0f, 0.5f * (x1 - x0));
    list.AddTriangleFilled({middle - half, axis.y_top}, {middle + half, axis.y_top}, {middle, axis.y_top - 1.4f * half},
                           to_u32(colors.text));
  }
  bars.push_back(shown);
}

/// Draws the id below a bar, and its value below the id if there are two `lines`.
void draw_bar_texts(ImDrawList& list, const Palette& colors, const Axis& axis, float x0, float x1, const BarValue& bar,
                    int lines) {
  const float line = kSmallText * ImGui::GetFontSize(), middle = 0.5f * (x0 + x1);
  const std::string id = std::to_string(bar.id);
  std::string value = number_in_unit(bar.value, axis.unit);
  if (bar.error > 0) {
    const std::string with_error = fmt::format("{} \xc2\xb1 {:.2g}", value, axis.unit.scale * bar.error);
    if (small_width(with_error) <= x1 - x0 + 2) value = with_error;
  }
  if (lines >= 1 && small_width(id) <= x1 - x0) {
    small_text(list, {std::round(middle - 0.5f * small_width(id)), axis.y_zero + 7}, to_u32(colors.text), id);
  }
  const bool quiet = bar.value <= 0;
  if (lines >= 2 && small_width(value) <= x1 - x0 + 2) {
    small_text(list, {std::round(middle - 0.5f * small_width(value)), axis.y_zero + 7 + line},
               to_u32(quiet ? colors.dim : colors.text), value);
  }
}

/// Returns the group of the selected sensor, or the first group.
const BarGroup& selected_group(const std::vector<BarGroup>& groups, const Viewer& viewer) {
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const BarGroup& group) { return group.sensor == viewer.selection.sensor; });
  return found == groups.end() ? groups.front() : *found;
}

/// Returns the number of lines of text that fit below the bars: names of sensors, ids, values. The bars themselves get
/// at least two lines of the panel, which has `lines`.
int lines_below(const std::vector<BarGroup>& groups, float step, float lines) {
  const int room = std::max(0, static_cast<int>(lines - 3.3f));
  if (groups.size() < 2) return std::min(2, room);
  float id = 0, value = 0;
  for (const BarGroup& group : groups) {
    for (const BarValue& bar : group.values) {
      id = std::max(id, small_width(std::to_string(bar.id)));
      value = std::max(value, small_width(number_in_unit(bar.value, group.unit)));
    }
  }
  return std::min(1 + (id <= step ? 1 : 0) + (value <= step + 2 ? 1 : 0), std::max(1, room));
}

/// Draws the name of a sensor below its bars. A unit that is not on the axis has the upper end of its axis here.
void draw_group_name(WindowUi& ui, ImDrawList& list, const BarGroup& group, const BarSpan& span, const Axis& axis,
                     bool on_axis, bool selected, float y) {
  const Palette& colors = palette(ui.dark);
  const std::string text =
      on_axis ? group.name : fmt::format("{} (to {:.3g} {})", group.name, axis.unit.scale * axis.top, axis.unit.text);
  const float width = small_width(text), x = std::round(std::max(span.x0, 0.5f * (span.x0 + span.x1 - width)));
  list.PushClipRect({span.x0, y}, {span.x1, y + 2 * ImGui::GetFontSize()}, true);
  small_text(list, {x, y}, to_u32(selected ? colors.accent : colors.text), text);
  list.PopClipRect();
  ui.widgets.note(kBars.title, "Bars of " + group.name, {span.x0, y, span.x1, y + kSmallText * ImGui::GetFontSize()});
}

}  // namespace

std::optional<ClickedBar> draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& bars,
                                             const std::vector<BarGroup>& groups, ImVec2 size, bool with_unit) {
  bars.clear();
  const Palette& colors = palette(ui.dark);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float line = kSmallText * ImGui::GetFontSize();
  ImGui::InvisibleButton("##bars", size);
  ui.widgets.note_item("Bars");
  const bool hovered = ImGui::IsItemHovered(), pressed = ImGui::IsItemClicked();
  std::vector<std::size_t> counts;
  for (const BarGroup& group : groups) counts.push_back(group.values.size());
  const float left = origin.x + (with_unit ? 4.6f : 2.6f) * line;
  const std::vector<BarSpan> spans = place_groups(counts, left, origin.x + size.x, line);
  if (spans.empty() || size.y < 2 * line) return std::nullopt;  // no room for an axis
  const BarGroup& first = selected_group(groups, viewer);
  const int texts = lines_below(groups, spans.front().step, size.y / line);
  const float below = (static_cast<float>(texts) + 0.7f) * line;
  Axis axis{left, origin.x + size.x, origin.y + size.y - below, origin.y + 0.6f * line, first.top, first.unit};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_axis(list, axis, colors, with_unit);
  std::optional<ClickedBar> clicked;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const BarGroup& group = groups[g];
    axis.unit = group.unit;
    axis.top = group.top;
    for (std::size_t i = 0; i < group.values.size(); ++i) {
      const BarValue& bar = group.values[i];
      const float x0 = spans[g].column(i), x1 = x0 + spans[g].step;
      draw_bar(ui, bars, list, axis, x0, x1, bar, is_selected(viewer.selection, {group.sensor, bar.id}));
      bars.back().sensor = group.sensor;
      const float inset = std::min(2.0f, 0.14f * (x1 - x0));
      const Rect strip{x0 + inset, axis.y_zero + 2, std::max(x0 + inset + 1, x1 - inset), axis.y_zero + 6};
      draw_in_taxel_color(list, strip, taxel_color(bar.color), colors);
      draw_bar_texts(list, colors, axis, x0, x1, bar, texts - (groups.size() > 1 ? 1 : 0));
      if (!hovered || !ImGui::IsMouseHoveringRect({x0, origin.y}, {x1, origin.y + size.y})) continue;
      const std::string name = groups.size() > 1 ? group.name + " " : std::string();
      const std::string error = bar.error > 0 ? " \xc2\xb1 " + in_unit(bar.error, group.unit) : "";
      ImGui::SetTooltip("Taxel %s%d: %s%s\npeak %s", name.c_str(), bar.id, in_unit(bar.value, group.unit).c_str(),
                        error.c_str(), in_unit(bar.peak, group.unit).c_str());
      if (pressed) clicked = ClickedBar{group.sensor, bar.id};
    }
    if (groups.size() > 1)
      draw_group_name(ui, list, group, spans[g], axis, same_unit(group.unit, first.unit),
                      group.sensor == viewer.selection.sensor, origin.y + size.y - 1.2f * line);
  }
  return clicked;
}

}  // namespace taxel::ui
