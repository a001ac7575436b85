#include "app/studio/nouns/video/video_notes.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "ui/scene/color_map.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"

namespace taxel::ui {
namespace {

constexpr int kBands = 64, kTicks = 4;
constexpr float kPlateAlpha = 0.82f;
constexpr float kLowLegend = 9;  // least height of a legend whose numbers do not overlap, in heights of text

/// A list to draw into, and the size of its texts.
struct VideoPage {
  ImDrawList& list;
  ImFont* font;
  float line;  ///< height of texts [pixels]
  const Palette& colors;

  [[nodiscard]] ImVec2 size_of(const std::string& text, float scale = 1) const {
    return font->CalcTextSizeA(scale * line, FLT_MAX, 0, text.c_str());
  }
  void text(ImVec2 at, const ImVec4& color, const std::string& what, float scale = 1) const {
    list.AddText(font, scale * line, {std::round(at.x), std::round(at.y)}, to_u32(color), what.c_str());
  }
  void plate(const Rect& rect) const {
    list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(colors.panel, kPlateAlpha), 0.25f * line);
  }
};

/// Returns a text of the same form whose digits are as wide as the widest one, and at least two before the point.
std::string widest_form(std::string text) {
  for (char& c : text)
    if (c >= '0' && c <= '9') c = '8';
  const std::size_t point = text.find('.');
  const bool has_one = point != std::string::npos && point >= 2 && text[point - 2] == ' ';
  return has_one ? text.insert(point - 1, "8") : text;
}

/// Draws the time, and the force below it. Returns their plate, whose width is the same for all forces below 100 N.
Rect draw_time(const VideoPage& page, float height, const std::string& time, const std::string& force) {
  constexpr float kSize = 1.3f;
  const float pad = 0.4f * page.line;
  const ImVec2 size = page.size_of(time, kSize), wide = page.size_of(widest_form(force), kSize);
  const float below = force.empty() ? 0 : wide.y + 0.2f * page.line;
  const ImVec2 lo(page.line, height - page.line - size.y - below - 2 * pad);
  const Rect plate{lo.x, lo.y, lo.x + std::max(size.x, wide.x) + 2 * pad, lo.y + size.y + below + 2 * pad};
  page.plate(plate);
  page.text({lo.x + pad, lo.y + pad}, page.colors.text, time, kSize);
  page.text({lo.x + pad, lo.y + pad + below}, page.colors.text, force, kSize);
  return plate;
}

/// One colour bar of the legend.
struct LegendColumn {
  std::string title;
  const PressureRange* range;
  ReadingUnit unit;
};

/// Returns the columns of the legend: one for both ranges if they are linked.
std::vector<LegendColumn> legend_columns(const LegendScales& scales) {
  if (scales.linked) return {{"Pressure [kPa]", &scales.surface, ReadingUnit{}}};
  return {{"Surface [kPa]", &scales.surface, ReadingUnit{}},
          {fmt::format("Readings [{}]", scales.unit.text), &scales.readings, scales.unit}};
}

/// Draws a colour bar with its numbers between two heights.
void draw_column(const VideoPage& page, const LegendColumn& column, float left, float top, float bottom) {
  const std::vector<std::string> texts = legend_texts(*column.range, kTicks, column.unit);
  const PressureRange& range = *column.range;
  const float line = page.line, bar = 1.1f * line;
  const auto value_at = [&](double part) { return range.lo + part * (range.hi - range.lo); };
  const auto y_at = [&](double part) { return bottom + (top - bottom) * static_cast<float>(part); };
  for (int i = 0; i < kBands; ++i) {
    const double a = static_cast<double>(i) / kBands, b = static_cast<double>(i + 1) / kBands;
    const ImU32 below = pressure_color(range, value_at(a)), above = pressure_color(range, value_at(b));
    page.list.AddRectFilledMultiColor({left, y_at(b)}, {left + bar, y_at(a)}, above, above, below, below);
  }
  for (int i = 0; i <= kTicks; ++i) {
    const float y = y_at(static_cast<double>(i) / kTicks);
    page.list.AddLine({left + bar, y}, {left + bar + 0.3f * line, y}, to_u32(page.colors.text),
                      std::max(1.0f, 0.06f * line));
    const std::string& text = texts[static_cast<std::size_t>(i)];
    page.text({left + bar + 0.6f * line, y - 0.5f * page.size_of(text).y}, page.colors.text, text);
  }
}

/// Draws the legend between the upper edge and `bottom`. Returns its plate, empty if there is too little room.
Rect draw_legend(const VideoPage& page, float width, float bottom, const LegendScales& scales) {
  const std::vector<LegendColumn> columns = legend_columns(scales);
  const float line = page.line, pad = 0.6f * line;
  std::vector<float> widths;
  float all = pad;
  for (const LegendColumn& column : columns) {
    float numbers = 0;
    for (const std::string& text : legend_texts(*column.range, kTicks, column.unit))
      numbers = std::max(numbers, page.size_of(text).x);
    widths.push_back(std::max(page.size_of(column.title).x, 1.8f * line + numbers) + pad);
    all += widths.back();
  }
  const float right = width - line;
  const Rect plate{right - all, line, right, std::min(14.5f * line, bottom)};
  if (plate.x0 < line || plate.height() < kLowLegend * line) return {};
  page.plate(plate);
  float left = plate.x0 + pad;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    page.text({left, 1.4f * line}, page.colors.text, columns[i].title);
    draw_column(page, columns[i], left, 3.4f * line, plate.y1 - line);
    left += widths[i];
  }
  return plate;
}

/// The rectangle of the bars' axes.
struct BarsArea {
  float x0, x1, top, bottom;
};

void draw_bar_of(const VideoPage& page, const BarGroup& group, const BarValue& bar, const BarsArea& column) {
  const float gap = 0.14f * (column.x1 - column.x0);
  const float left = std::round(column.x0 + gap), right = std::max(left + 1, std::round(column.x1 - gap));
  const float fraction = static_cast<float>(std::clamp(group.top > 0 ? bar.value / group.top : 0.0, 0.0, 1.0));
  const float y = column.bottom - fraction * (column.bottom - column.top);
  page.list.AddRectFilled({left, column.top}, {right, column.bottom}, to_u32(page.colors.field));
  if (y < column.bottom) {
    page.list.AddRectFilled({left, y}, {right, column.bottom}, taxel_color_u32(bar.color));
    const glm::vec3 back(page.colors.field.x, page.colors.field.y, page.colors.field.z);
    if (right - left > 4 && needs_outline(taxel_color(bar.color), back))
      page.list.AddRect({left, y}, {right, column.bottom}, to_u32(page.colors.dim));
  }
  page.list.AddRectFilled({left, column.bottom + 2}, {right, column.bottom + 2 + 0.3f * page.line},
                          taxel_color_u32(bar.color));
}

constexpr float kSmall = 0.85f;  // size of the texts below the bars

/// Draws a text in the middle between two places, if it fits.
void draw_centered(const VideoPage& page, const std::string& text, float x0, float x1, float y) {
  const float width = page.size_of(text, kSmall).x;
  if (width <= x1 - x0) page.text({0.5f * (x0 + x1 - width), y}, page.colors.text, text, kSmall);
}

/// Draws the ids of the taxels of a sensor below their bars, every nth if not all fit.
void draw_bar_ids(const VideoPage& page, const std::vector<BarValue>& values, const BarSpan& span, float y) {
  float widest = 0;
  for (const BarValue& bar : values) widest = std::max(widest, page.size_of(std::to_string(bar.id), kSmall).x);
  const std::size_t stride = text_stride(widest + 0.4f * page.line, span.step);
  const float half = 0.5f * (static_cast<float>(stride) - 1) * span.step;
  for (std::size_t i = 0; i < values.size(); i += stride)
    draw_centered(page, std::to_string(values[i].id), span.column(i) - half, span.column(i) + span.step + half, y);
}

/// Draws the ids of the taxels below the bars, and below them the names of several sensors.
void draw_bar_names(const VideoPage& page, const std::vector<BarGroup>& groups, const std::vector<BarSpan>& spans,
                    float y) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    draw_bar_ids(page, groups[g].values, spans[g], y);
    if (groups.size() > 1) draw_centered(page, groups[g].name, spans[g].x0, spans[g].x1, y + 1.1f * page.line);
  }
}

/// Draws the bars of all sensors between `left` and the right edge of the image. Returns their plate, empty if there is
/// too little room.
Rect draw_bars(const VideoPage& page, float left, ImVec2 image, const VideoNotes& notes) {
  std::vector<std::size_t> counts;
  std::vector<int> chains;
  std::size_t columns = 0;
  for (const BarGroup& group : notes.bars) {
    counts.push_back(group.values.size());
    chains.push_back(group.place.chain);
    columns += group.values.size();
  }
  const BarGroup& first = selected_group(notes.bars, notes.selection);
  const float line = page.line, pad = 0.6f * line;
  const std::string title = fmt::format("Readings [{}]", first.unit.text),
                    top = fmt::format("{:.3g}", first.unit.scale * first.top);
  const float axis = std::max(page.size_of(top).x, page.size_of("0").x) + 0.5f * line;
  const float room = image.x - line - left;
  const float wanted = std::max(page.size_of(title).x, axis + 2.6f * line * static_cast<float>(columns)) + 2 * pad;
  const float names = notes.bars.size() > 1 ? 1.1f * line : 0;  // height of the names of several sensors
  const Rect plate{image.x - line - std::min(room, wanted), image.y - 10 * line - names, image.x - line,
                   image.y - line};
  if (plate.width() < 2 * axis + 2 * pad) return {};
  page.plate(plate);
  page.text({plate.x0 + pad, plate.y0 + 0.4f * line}, page.colors.text, title);
  const BarsArea area{plate.x0 + pad + axis, plate.x1 - pad, plate.y0 + 2.3f * line, plate.y1 - 2.1f * line - names};
  page.list.AddLine({area.x0, area.top}, {area.x1, area.top}, to_u32(page.colors.line));
  page.list.AddLine({area.x0, area.bottom}, {area.x1, area.bottom}, to_u32(page.colors.dim));
  page.text({area.x0 - 0.5f * line - page.size_of(top).x, area.top - 0.5f * line}, page.colors.text, top);
  page.text({area.x0 - 0.5f * line - page.size_of("0").x, area.bottom - 0.6f * line}, page.colors.text, "0");
  const std::vector<BarSpan> spans = place_groups(counts, chains, area.x0, area.x1, line);
  for (std::size_t g = 0; g < spans.size(); ++g) {
    for (std::size_t i = 0; i < notes.bars[g].values.size(); ++i) {
      const float x0 = spans[g].column(i);
      draw_bar_of(page, notes.bars[g], notes.bars[g].values[i], {x0, x0 + spans[g].step, area.top, area.bottom});
    }
  }
  if (!spans.empty()) draw_bar_names(page, notes.bars, spans, area.bottom + 0.6f * line);
  return plate;
}

}  // namespace

VideoPlates draw_video_notes(ImDrawList& list, ImVec2 image, const VideoNotes& notes) {
  const float line = std::max(10.0f, std::round(0.024f * std::min(image.x, image.y)));
  const VideoPage page{list, ImGui::GetIO().Fonts->Fonts[0], line, palette(notes.dark)};
  VideoPlates plates;
  if (!notes.time.empty()) plates.time = draw_time(page, image.y, notes.time, notes.force);
  if (!notes.bars.empty()) plates.bars = draw_bars(page, plates.time.x1 + line, image, notes);
  const float low =
      std::min(plates.bars.empty() ? image.y : plates.bars.y0, notes.time.empty() ? image.y : plates.time.y0);
  if (notes.legend) plates.legend = draw_legend(page, image.x, low - line, *notes.legend);
  return plates;
}

}  // namespace taxel::ui
