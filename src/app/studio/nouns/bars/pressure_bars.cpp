#include "app/studio/nouns/bars/pressure_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "core/base/text/rounded.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {

std::vector<BarSpan> place_groups(std::span<const std::size_t> counts, std::span<const int> chains, float x0, float x1,
                                  float gap) {
  std::vector<BarSpan> spans;
  const std::size_t columns = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (columns == 0) return spans;
  const bool has_chains = std::adjacent_find(chains.begin(), chains.end()) != chains.end();
  const auto gaps_before = [&](std::size_t g) { return g == 0 ? 0 : has_chains && chains[g] != chains[g - 1] ? 2 : 1; };
  int gaps = 0;
  for (std::size_t g = 0; g < counts.size(); ++g) gaps += gaps_before(g);
  const float between = gaps > 0 ? std::min(gap, (x1 - x0) / static_cast<float>(3 * gaps)) : 0.0f;
  const float step = (x1 - x0 - static_cast<float>(gaps) * between) / static_cast<float>(columns);
  float at = x0;
  for (std::size_t g = 0; g < counts.size(); ++g) {
    at += static_cast<float>(gaps_before(g)) * between;
    spans.push_back({at, at + static_cast<float>(counts[g]) * step, step});
    at = spans.back().x1;
  }
  return spans;
}

std::size_t text_stride(float widest, float step) {
  std::size_t decade = 1;
  for (; decade < 1000; decade *= 10)
    for (const std::size_t digit : {1, 2, 5})
      if (widest <= static_cast<float>(digit * decade) * step) return digit * decade;
  return decade;
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

/// Draws lines and values of the axis; the uppermost value has the unit if `with_unit`.
void draw_axis(ImDrawList& list, const Axis& axis, const Palette& colors, bool with_unit, BarsShown& shown) {
  const int ticks = tick_count(axis.y_zero - axis.y_top, kSmallText * ImGui::GetFontSize());
  for (int i = 0; i <= ticks; ++i) {
    const double value = axis.top * i / ticks;
    const float y = std::floor(axis.y(value));
    list.AddLineH(axis.x0, axis.x1, y, to_u32(i == 0 ? colors.dim : colors.line));
    const std::string unit = with_unit && i == ticks ? fmt::format(" {}", axis.unit.text) : "";
    const std::string text = fmt::format("{:.3g}{}", axis.unit.scale * value, unit);
    draw_small_text(list, {axis.x0 - small_width(text) - 5, y - 0.5f * kSmallText * ImGui::GetFontSize()},
                    to_u32(colors.dim), text, shown.texts);
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

/// Draws the error bar of a reading, in the middle of its bar, dark on light and light on dark. Its caps have two
/// thirds of the bar's width and its lines a twelfth, within limits that grow with the text.
void draw_whisker(ImDrawList& list, const Axis& axis, const BarValue& bar, float left, float right,
                  const Palette& colors, BarShown& shown) {
  constexpr float kCaps = 2.0f / 3, kLine = 1.0f / 12;                         // of the bar's width
  constexpr float kMostCaps = 1.6f, kLeastLine = 1.0f / 15, kMostLine = 0.2f;  // in heights of text
  const float text = ImGui::GetFontSize(), width = right - left;
  const float x = std::floor(0.5f * (left + right)), half = 0.5f * std::min(kMostCaps * text, kCaps * width);
  const float lo = axis.y(bar.value - bar.error), hi = axis.y(bar.value + bar.error);
  const float line = std::clamp(kLine * width, std::max(1.0f, kLeastLine * text), kMostLine * text),
              halo = 2 * kLeastLine * text;
  for (const auto& [color, wide] : {std::pair(colors.field, line + halo), std::pair(colors.text, line)}) {
    list.AddLine({x, lo}, {x, hi}, to_u32(color), wide);
    list.AddLineH(x - half, x + half, lo, to_u32(color), wide);
    list.AddLineH(x - half, x + half, hi, to_u32(color), wide);
  }
  shown.whisker = {x - half, hi, x + half, lo};
  shown.whisker_line = line;
}

/// Draws one bar within its column of the axis, from x0 to x1.
BarShown draw_bar(const Palette& colors, ImDrawList& list, const Axis& axis, float x0, float x1, const BarValue& bar,
                  bool selected) {
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
  shown.y_mark = axis.y(std::max(bar.peak, bar.value + bar.error));
  if (bar.error > 0) draw_whisker(list, axis, bar, left, right, colors, shown);
  if (bar.peak > 0) list.AddLineH(left, right, axis.y(bar.peak), to_u32(colors.text), 1.5f);
  if (shown.over) {
    const float middle = 0.5f * (left + right), half = std::min(4.0f, 0.5f * (x1 - x0));
    shown.y_mark = axis.y_top - 1.4f * half;
    list.AddTriangleFilled({middle - half, axis.y_top}, {middle + half, axis.y_top}, {middle, axis.y_top - 1.4f * half},
                           to_u32(colors.text));
  }
  return shown;
}

/// The lines of text around the bars: ids and names of sensors below them, and values, each of which may be left out.
/// The values are below the bars if all of them fit there, otherwise some of them are directly above their bars.
struct TextLines {
  bool ids = false, values_below = false, values_above = false, names = false;
  [[nodiscard]] int below() const { return (ids ? 1 : 0) + (values_below ? 1 : 0) + (names ? 1 : 0); }
};

constexpr float kLineGap = 0.4f;               // gap between texts of a line [heights of text]
constexpr std::size_t kMaxStride = 10;         // with more bars between two ids, ids do not help to find a taxel
constexpr std::size_t kMaxWrittenValues = 60;  // values that are tried where not all fit

/// Returns the width of the widest value, or more than `limit` if one is wider than that.
float widest_value(const std::vector<BarGroup>& groups, float limit) {
  float widest = 0;
  for (const BarGroup& group : groups) {
    for (const BarValue& bar : group.values) {
      widest = std::max(widest, small_width(number_in_unit(bar.value, group.unit)));
      if (widest > limit) return widest;
    }
  }
  return widest;
}

/// Returns the width of the largest id.
float widest_id(const std::vector<BarGroup>& groups) {
  int largest = 0;
  for (const BarGroup& group : groups)
    for (const BarValue& bar : group.values) largest = std::max(largest, bar.id);
  return small_width(std::to_string(largest));
}

/// Returns the lines of text. The bars themselves get at least two lines of the panel, which has `lines`.
TextLines text_lines(const std::vector<BarGroup>& groups, std::size_t stride, bool all_values, float lines) {
  constexpr int kRoomy = 4;  // lines at which some values are worth their line
  const int room = std::max(0, static_cast<int>(lines - 3.3f));
  TextLines texts;
  texts.names = groups.size() > 1;
  const int left = std::max(texts.names ? 1 : 0, room) - texts.below();
  texts.ids = left >= 1 && stride <= kMaxStride;
  const bool has_room = left - (texts.ids ? 1 : 0) >= 1;
  texts.values_below = has_room && all_values;
  texts.values_above = has_room && !all_values && (groups.size() < 2 || room >= kRoomy);
  return texts;
}

/// The bars in this frame.
struct BarsFrame {
  const Viewer& viewer;
  const std::vector<BarGroup>& groups;
  const std::vector<BarSpan>& spans;
  ImDrawList& list;
  const Palette& colors;
  float line = 0;             ///< height of small text [pixels]
  float left = 0, right = 0;  ///< ends of the panel's content [pixels]

  [[nodiscard]] bool selected(const BarGroup& group, const BarValue& bar) const {
    return is_selected(viewer.selection, {group.sensor, bar.id});
  }
  /// Returns the left end of a text below a bar.
  [[nodiscard]] float text_x(std::size_t group, std::size_t bar, float width) const {
    const float x = spans[group].column(bar) + 0.5f * (spans[group].step - width);
    return std::round(std::clamp(x, left, std::max(left, right - width)));
  }
};

/// Draws the ids below the bars: those of selected taxels, and every `stride`th of each sensor if there is room.
void draw_ids(const BarsFrame& frame, std::size_t stride, float y, BarsShown& shown) {
  TextLine line(kLineGap * frame.line);
  for (const bool of_selected : {true, false}) {
    for (std::size_t g = 0; g < frame.groups.size(); ++g) {
      for (std::size_t i = 0; i < frame.groups[g].values.size(); ++i) {
        const BarValue& bar = frame.groups[g].values[i];
        const bool selected = frame.selected(frame.groups[g], bar);
        if (selected != of_selected || (!selected && i % stride != 0)) continue;
        const std::string id = std::to_string(bar.id);
        const float x = frame.text_x(g, i, small_width(id));
        if (!line.reserve(x, x + small_width(id))) continue;
        draw_small_text(frame.list, {x, y}, to_u32(selected ? frame.colors.accent : frame.colors.text), id,
                        shown.texts);
      }
    }
  }
}

/// Returns the value of a bar, with its error bar if both fit in the column.
std::string value_text(const BarsFrame& frame, const BarGroup& group, const BarValue& bar, float step) {
  const std::string value = number_in_unit(bar.value, group.unit);
  if (!(bar.error > 0)) return value;
  const std::string with_error = fmt::format("{} \xc2\xb1 {}", value, rounded(group.unit.scale * bar.error, 2, 4));
  return small_width(with_error) + kLineGap * frame.line <= step ? with_error : value;
}

/// Draws the values of all bars below them.
void draw_values_below(const BarsFrame& frame, float y, BarsShown& shown) {
  TextLine line(kLineGap * frame.line);
  for (std::size_t g = 0; g < frame.groups.size(); ++g) {
    for (std::size_t i = 0; i < frame.groups[g].values.size(); ++i) {
      const BarValue& bar = frame.groups[g].values[i];
      const std::string value = value_text(frame, frame.groups[g], bar, frame.spans[g].step);
      const float width = small_width(value), x = frame.text_x(g, i, width);
      if (line.reserve(x, x + width))
        draw_small_text(frame.list, {x, y}, to_u32(bar.value > 0 ? frame.colors.text : frame.colors.dim), value,
                        shown.texts);
    }
  }
}

/// Returns whether a text at `place` covers no other text and no part of a bar.
bool is_free(const Rect& place, float gap, const BarsShown& shown) {
  const auto crosses = [&](const Rect& other) {
    return other.x0 < place.x1 && place.x0 < other.x1 && other.y0 < place.y1 && place.y0 < other.y1;
  };
  return std::none_of(shown.texts.begin(), shown.texts.end(),
                      [&](const TextShown& text) {
                        const Rect& r = text.rect;
                        return crosses({r.x0 - gap, r.y0, r.x1 + gap, r.y1});
                      }) &&
         std::none_of(shown.bars.begin(), shown.bars.end(), [&](const BarShown& bar) {
           return crosses({bar.rect.x0, bar.y_mark, bar.rect.x1, bar.rect.y1});
         });
}

/// Draws values directly above their bars where they cover nothing: those of selected taxels first, and then those with
/// the largest peaks. Unlike readings, peaks keep their order while a contact moves.
void draw_values_above(const BarsFrame& frame, BarsShown& shown) {
  struct Candidate {
    bool selected;
    double peak;
    std::size_t group, bar, drawn;
  };
  std::vector<Candidate> candidates;
  std::size_t drawn = 0;
  for (std::size_t g = 0; g < frame.groups.size(); ++g) {
    for (std::size_t i = 0; i < frame.groups[g].values.size(); ++i, ++drawn) {
      const BarValue& bar = frame.groups[g].values[i];
      const bool selected = frame.selected(frame.groups[g], bar);
      const double peak = std::max(bar.peak, bar.value) / std::max(1e-300, frame.groups[g].top);
      if (selected || bar.value > 0) candidates.push_back({selected, peak, g, i, drawn});
    }
  }
  const auto first = [](const Candidate& a, const Candidate& b) {
    return std::tuple(!a.selected, -a.peak, a.drawn) < std::tuple(!b.selected, -b.peak, b.drawn);
  };
  const std::size_t tried = std::min(kMaxWrittenValues, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(tried), candidates.end(),
                    first);
  candidates.resize(tried);
  for (const Candidate& each : candidates) {
    const BarGroup& group = frame.groups[each.group];
    const BarValue& bar = group.values[each.bar];
    const std::string value = value_text(frame, group, bar, frame.spans[each.group].step);
    const float width = small_width(value), x = frame.text_x(each.group, each.bar, width);
    float mark = shown.bars[each.drawn].y_mark;
    for (const BarShown& other : shown.bars)  // a selected taxel has its value, even above higher neighbours
      if (each.selected && other.rect.x0 < x + width && x < other.rect.x1) mark = std::min(mark, other.y_mark);
    const float bottom = std::floor(mark - 0.15f * frame.line);
    const Rect place{x, bottom - frame.line, x + width, bottom};
    if (is_free(place, kLineGap * frame.line, shown))
      draw_small_text(frame.list, {place.x0, place.y0}, to_u32(frame.colors.text), value, shown.texts);
  }
}

/// Draws the names of the sensors below their bars, shortened to the room up to the next sensor. A unit that is not on
/// the axis has the upper end of its axis here.
void draw_group_names(WindowUi& ui, const BarsFrame& frame, const ReadingUnit& on_axis, float y, BarsShown& shown) {
  for (std::size_t g = 0; g < frame.groups.size(); ++g) {
    const BarGroup& group = frame.groups[g];
    const BarSpan& span = frame.spans[g];
    const float gap = kLineGap * frame.line;
    const float before = g == 0 ? frame.left : 0.5f * (frame.spans[g - 1].x1 + span.x0 + gap);
    const float after = g + 1 == frame.spans.size() ? frame.right : 0.5f * (span.x1 + frame.spans[g + 1].x0 - gap);
    const std::string text =
        same_unit(group.unit, on_axis)
            ? group.name
            : fmt::format("{} (to {:.3g} {})", group.name, group.unit.scale * group.top, group.unit.text);
    const std::string name = shortened(text, after - before);
    const float width = small_width(name);
    const float x = std::clamp(0.5f * (span.x0 + span.x1 - width), before, std::max(before, after - width));
    const bool selected = group.sensor == frame.viewer.selection.sensor;
    if (!name.empty())
      draw_small_text(frame.list, {std::ceil(x), y}, to_u32(selected ? frame.colors.accent : frame.colors.text), name,
                      shown.texts);
    ui.widgets.note(kBars.title, "Bars of " + group.name, {span.x0, y, span.x1, y + frame.line});
  }
}

/// Draws the bars of one group. Returns the index of the bar under the pointer, if any.
std::optional<std::size_t> draw_group(const BarsFrame& frame, std::size_t g, const Axis& axis, const Rect& panel,
                                      bool hovered, BarsShown& shown) {
  const BarGroup& group = frame.groups[g];
  const BarSpan& span = frame.spans[g];
  std::optional<std::size_t> under;
  for (std::size_t i = 0; i < group.values.size(); ++i) {
    const BarValue& bar = group.values[i];
    const float x0 = span.column(i), x1 = x0 + span.step;
    shown.bars.push_back(draw_bar(frame.colors, frame.list, axis, x0, x1, bar, frame.selected(group, bar)));
    shown.bars.back().sensor = group.sensor;
    const float inset = std::min(2.0f, 0.14f * (x1 - x0));
    const Rect strip{x0 + inset, axis.y_zero + 2, std::max(x0 + inset + 1, x1 - inset), axis.y_zero + 6};
    draw_in_taxel_color(frame.list, strip, taxel_color(bar.color), frame.colors);
    if (hovered && ImGui::IsMouseHoveringRect({x0, panel.y0}, {x1, panel.y1})) under = i;
  }
  return under;
}

}  // namespace

const BarGroup& selected_group(const std::vector<BarGroup>& groups, const Selection& selection) {
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const BarGroup& group) { return group.sensor == selection.sensor; });
  return found == groups.end() ? groups.front() : *found;
}

std::string bar_tip(const std::vector<BarGroup>& groups, const BarGroup& group, const BarValue& bar) {
  const std::string sensor = groups.size() > 1 ? group.name + " " : std::string();
  const std::string name = bar.name.empty() ? "" : fmt::format(", {}", bar.name);
  const std::string error = bar.error > 0 ? " \xc2\xb1 " + in_unit(bar.error, group.unit) : "";
  return fmt::format("Taxel {}{}{}: {}{}\npeak {}", sensor, bar.id, name, in_unit(bar.value, group.unit), error,
                     in_unit(bar.peak, group.unit));
}

bool fits_as_bars(const std::vector<BarGroup>& groups, float width, float pixel_scale) {
  constexpr float kMinColumn = 7;  // [pixels at scale 1]: a bar of 5 pixels with gaps, wide enough to be clicked
  std::vector<std::size_t> counts;
  std::vector<int> chains;
  for (const BarGroup& group : groups) {
    counts.push_back(group.values.size());
    chains.push_back(group.place.chain);
  }
  const float line = kSmallText * ImGui::GetFontSize();
  const std::vector<BarSpan> spans = place_groups(counts, chains, 0, std::max(1.0f, width - 2.6f * line), line);
  return spans.empty() || spans.front().step >= kMinColumn * pixel_scale;
}

std::optional<ClickedBar> draw_pressure_bars(WindowUi& ui, const Viewer& viewer, BarsShown& shown,
                                             const std::vector<BarGroup>& groups, ImVec2 size, bool with_unit) {
  shown = {};
  const Palette& colors = palette(ui.dark);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float line = kSmallText * ImGui::GetFontSize();
  ImGui::InvisibleButton("##bars", size);
  ui.widgets.note_item("Bars");
  const bool hovered = ImGui::IsItemHovered(), pressed = ImGui::IsItemClicked();
  std::vector<std::size_t> counts;
  std::vector<int> chains;
  for (const BarGroup& group : groups) {
    counts.push_back(group.values.size());
    chains.push_back(group.place.chain);
  }
  const float left = origin.x + (with_unit ? 4.6f : 2.6f) * line, right = origin.x + size.x;
  const std::vector<BarSpan> spans = place_groups(counts, chains, left, right, line);
  if (spans.empty() || size.y < 2 * line) return std::nullopt;  // no room for an axis
  const float step = spans.front().step, room = step - kLineGap * line;
  const std::size_t stride = text_stride(widest_id(groups) + kLineGap * line, step);
  const bool all_values = widest_value(groups, room) <= room;
  const TextLines texts = text_lines(groups, stride, all_values, size.y / line);
  const BarGroup& first = selected_group(groups, viewer.selection);
  Axis axis{left,
            right,
            origin.y + size.y - (static_cast<float>(texts.below()) + 0.7f) * line,
            origin.y + (texts.values_above ? 1.6f : 0.6f) * line,
            first.top,
            first.unit};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const BarsFrame frame{viewer, groups, spans, list, colors, line, origin.x, right};
  draw_axis(list, axis, colors, with_unit, shown);
  std::optional<ClickedBar> clicked;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    axis.unit = groups[g].unit;
    axis.top = groups[g].top;
    const auto under = draw_group(frame, g, axis, {origin.x, origin.y, right, origin.y + size.y}, hovered, shown);
    if (!under) continue;
    ImGui::SetTooltip("%s", bar_tip(groups, groups[g], groups[g].values[*under]).c_str());
    if (pressed) clicked = ClickedBar{groups[g].sensor, groups[g].values[*under].id};
  }
  float y = axis.y_zero + std::min(7.0f, 0.6f * line);  // below the strips of colours
  if (texts.ids) draw_ids(frame, stride, std::exchange(y, y + line), shown);
  if (texts.values_below) draw_values_below(frame, std::exchange(y, y + line), shown);
  if (texts.values_above) draw_values_above(frame, shown);
  if (texts.names) draw_group_names(ui, frame, first.unit, y, shown);
  return clicked;
}

}  // namespace taxel::ui
