#include "app/studio/nouns/bars/taxel_cells.h"

#include <algorithm>
#include <cmath>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "ui/theme.h"
#include "ui/widgets/pressure_legend.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {
namespace {

constexpr float kMaxAspect = 1.6f;       // width of a cell over its height
constexpr float kMaxCellHeight = 1.4f;   // [heights of text]
constexpr float kSensorGap = 2;          // gap below each sensor [pixels]
constexpr float kChainGap = 0.5f;        // more gap next to a chain of several sensors [heights of text]
constexpr float kColumnGap = 1.0f;       // gap between columns of sensors [heights of text]
constexpr std::size_t kMaxColumns = 12;  // columns of sensors that are tried
constexpr std::size_t kMaxLines = 8;     // lines of cells of one sensor that are tried

/// The sensors that are placed, with the largest number of cells in a line.
struct CellRows {
  std::span<const std::size_t> counts;
  std::span<const int> chains;
  const CellSizes& sizes;
  std::size_t per_line = 1;

  [[nodiscard]] std::size_t lines(std::size_t sensor) const {
    return std::max<std::size_t>(1, (counts[sensor] + per_line - 1) / per_line);
  }
  /// Returns the height of a sensor with cells of a height, with the gap below it.
  [[nodiscard]] float height(std::size_t sensor, float cell) const {
    return std::max(sizes.line, static_cast<float>(lines(sensor)) * cell) + kSensorGap;
  }
  [[nodiscard]] float chain_gap() const { return kChainGap * sizes.line; }

  /// Returns the first sensor after the chain of a sensor.
  [[nodiscard]] std::size_t end_of_chain(std::size_t sensor) const {
    std::size_t end = sensor + 1;
    while (end < counts.size() && !chains.empty() && chains[end] == chains[sensor]) ++end;
    return end;
  }
};

/// The column and the upper end of each sensor.
struct CellColumns {
  std::vector<std::size_t> columns;
  std::vector<float> tops;
  std::size_t count = 1;
  float height = 0;
};

/// Fills columns of a height from top to bottom. A chain begins a new column if it fits into one, but not into the rest
/// of the present one.
CellColumns fill_columns(const CellRows& rows, float cell, float height) {
  CellColumns filled;
  float y = 0;
  std::size_t before = 1;  // sensors of the previous chain
  for (std::size_t s = 0; s < rows.counts.size();) {
    const std::size_t end = rows.end_of_chain(s), sensors = end - s;
    float chain = -kSensorGap, least = -kSensorGap;
    for (std::size_t k = s; k < end; ++k) {
      chain += rows.height(k, cell);
      least += rows.height(k, 0);
    }
    if (least <= height) filled.height = std::max(filled.height, chain);  // smaller cells keep the chain together
    if (y > 0 && std::max(before, sensors) > 1) y += rows.chain_gap();
    if (y > 0 && chain <= height && y + chain > height) ++filled.count, y = 0;
    for (; s < end; ++s) {
      if (y > 0 && y + rows.height(s, cell) - kSensorGap > height) ++filled.count, y = 0;
      filled.columns.push_back(filled.count - 1);
      filled.tops.push_back(y);
      y += rows.height(s, cell);
      filled.height = std::max(filled.height, y - kSensorGap);
    }
    before = sensors;
  }
  return filled;
}

/// Returns the largest height of a cell with which everything fits into `columns` columns; 0 if nothing fits.
float largest_height(const CellRows& rows, std::size_t columns, float height) {
  const auto fits = [&](float cell) {
    const CellColumns filled = fill_columns(rows, cell, height);
    return filled.count <= columns && filled.height <= height;
  };
  float lo = 0, hi = kMaxCellHeight * rows.sizes.line;
  if (!fits(lo)) return 0;
  if (fits(hi)) return hi;
  for (int i = 0; i < 8; ++i) {
    const float middle = 0.5f * (lo + hi);
    (fits(middle) ? lo : hi) = middle;
  }
  return lo;
}

/// Returns the plan with the largest cells for a room.
CellPlan best_plan(CellRows rows, ImVec2 room) {
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(rows.counts.begin(), rows.counts.end()));
  CellPlan best;
  float best_size = -1;
  for (std::size_t columns = 1; columns <= std::min(kMaxColumns, rows.counts.size()); ++columns) {
    const float gaps = static_cast<float>(columns - 1) * kColumnGap * rows.sizes.line;
    const float column = (room.x - gaps) / static_cast<float>(columns), cells = column - rows.sizes.name;
    for (std::size_t lines = 1; lines <= std::min(kMaxLines, most) && cells > 0; ++lines) {
      rows.per_line = (most + lines - 1) / lines;
      const float wide = cells / static_cast<float>(rows.per_line);
      if (wide <= best_size) continue;
      const float high = largest_height(rows, columns, room.y), size = std::min(wide, high);
      if (size <= best_size) continue;
      best_size = size;
      best = {std::min(wide, kMaxAspect * high), high, 0, {}};
      const CellColumns filled = fill_columns(rows, high, room.y);
      best.total_height = filled.height;
      for (std::size_t s = 0; s < rows.counts.size(); ++s) {
        const auto of_lines = static_cast<float>(rows.lines(s)) * high, of_all = rows.height(s, high) - kSensorGap;
        const float x = static_cast<float>(filled.columns[s]) * (column + kColumnGap * rows.sizes.line);
        const std::size_t in_line = (rows.counts[s] + rows.lines(s) - 1) / rows.lines(s);
        best.sensors.push_back({x + rows.sizes.name, filled.tops[s] + 0.5f * (of_all - of_lines), filled.tops[s],
                                of_all, std::max<std::size_t>(1, in_line)});
      }
    }
  }
  return best;
}

/// Returns the width of the names with a gap, at most a third of the room.
float names_width(const std::vector<BarGroup>& groups, float room, float line) {
  float widest = 0;
  if (groups.size() > 1)
    for (const BarGroup& group : groups) widest = std::max(widest, small_width(group.name) + 0.6f * line);
  return std::min(widest, room / 3);
}

/// Draws the name of a sensor at the left of its cells.
void draw_cells_name(WindowUi& ui, const BarGroup& group, ImVec2 at, float width, bool selected, BarsShown& shown) {
  const Palette& colors = palette(ui.dark);
  const float line = kSmallText * ImGui::GetFontSize();
  const std::string name = shortened(group.name, width - 0.6f * line);
  if (!name.empty())
    draw_small_text(*ImGui::GetWindowDrawList(), {std::ceil(at.x), std::round(at.y)},
                    to_u32(selected ? colors.accent : colors.text), name, shown.texts);
  ui.widgets.note(kBars.title, "Cells of " + group.name, {at.x, at.y, at.x + width, at.y + line});
}

/// Draws a cell, with a gap to the next one if it is large enough.
void draw_cell_of(ImDrawList& list, const Rect& rect, ImU32 color) {
  const float gap = std::min(rect.width(), rect.height()) >= 5 ? 1.0f : 0.0f;
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1 - gap, rect.y1 - gap}, color);
}

}  // namespace

Rect CellPlan::cell(const ImVec2& origin, std::size_t sensor, std::size_t taxel) const {
  const SensorCells& cells = sensors[sensor];
  const std::size_t row = taxel / cells.columns, column = taxel % cells.columns;
  const float x = origin.x + cells.x, y = origin.y + cells.y;
  return {x + static_cast<float>(column) * width, y + static_cast<float>(row) * height,
          x + static_cast<float>(column + 1) * width, y + static_cast<float>(row + 1) * height};
}

CellPlan place_cells(std::span<const std::size_t> counts, std::span<const int> chains, ImVec2 room,
                     const CellSizes& sizes) {
  constexpr int kMaxTries = 40;
  if (counts.empty()) return {};
  CellPlan plan;
  for (int i = 0; i < kMaxTries; ++i) {
    plan = best_plan({counts, chains, sizes}, room);
    if (std::min(plan.width, plan.height) >= sizes.least) break;
    room.y *= 1.2f;
  }
  return plan;
}

std::optional<ClickedBar> draw_taxel_cells(WindowUi& ui, const Viewer& viewer, BarsShown& shown,
                                           const std::vector<BarGroup>& groups, ImVec2 size) {
  shown = {};
  const Palette& colors = palette(ui.dark);
  const float line = kSmallText * ImGui::GetFontSize(), scale = static_cast<float>(ui.pixel_scale);
  std::vector<std::size_t> counts;
  std::vector<int> chains;
  for (const BarGroup& group : groups) {
    counts.push_back(group.values.size());
    chains.push_back(group.place.chain);
  }
  const float width = std::max(1.0f, size.x - ImGui::GetStyle().ScrollbarSize);
  const CellSizes sizes{names_width(groups, width, line), line, 3 * scale};
  const CellPlan plan = place_cells(counts, chains, {width, std::max(line, size.y)}, sizes);
  std::optional<ClickedBar> clicked;
  if (ImGui::BeginChild("##cells", size)) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##all", {width, std::max(line, plan.total_height)});
    ui.widgets.note_item("Cells");
    const bool hovered = ImGui::IsItemHovered(), pressed = ImGui::IsItemClicked();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = list.GetClipRectMin().y, bottom = list.GetClipRectMax().y;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::vector<Rect> selected;
    for (std::size_t g = 0; g < groups.size() && g < plan.sensors.size(); ++g) {
      const BarGroup& group = groups[g];
      const float y = origin.y + plan.sensors[g].top;
      if (y > bottom || y + plan.sensors[g].height < top) continue;
      if (groups.size() > 1)
        draw_cells_name(ui, group, {origin.x + plan.sensors[g].x - sizes.name, y}, sizes.name,
                        group.sensor == viewer.selection.sensor, shown);
      for (std::size_t i = 0; i < group.values.size(); ++i) {
        const BarValue& bar = group.values[i];
        const Rect rect = plan.cell(origin, g, i);
        const glm::vec3 color = group.range.color(bar.value);
        draw_cell_of(list, rect, pressure_color(group.range, bar.value));
        shown.cells.push_back({group.sensor, bar.id, bar.value, color, rect});
        if (is_selected(viewer.selection, {group.sensor, bar.id})) selected.push_back(rect);
        if (!hovered || mouse.x < rect.x0 || mouse.x >= rect.x1 || mouse.y < rect.y0 || mouse.y >= rect.y1) continue;
        ImGui::SetTooltip("%s", bar_tip(groups, group, bar).c_str());
        if (pressed) clicked = ClickedBar{group.sensor, bar.id};
      }
    }
    for (const Rect& rect : selected)
      list.AddRect({rect.x0 - 2, rect.y0 - 2}, {rect.x1 + 1, rect.y1 + 1}, to_u32(colors.accent), 0, 2 * scale);
  }
  ImGui::EndChild();
  return clicked;
}

}  // namespace taxel::ui
