#include "app/studio/nouns/heat/heat_drawing.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/heat/heat.h"
#include "ui/theme.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

namespace {

void small_label(ImVec2 pos, ImU32 color, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), kSmallText * ImGui::GetFontSize(), pos, color, text.c_str());
}

float small_label_width(const std::string& text) {
  return kSmallText * ImGui::CalcTextSize(text.c_str()).x;
}

}  // namespace

std::array<float, 2> heat_label_widths(const std::vector<SensorShown>& sensors, const std::vector<HeatRow>& rows,
                                       const HeatPlaces& places) {
  const float line = ImGui::GetFontSize();
  float names = 0, ids = 0;
  for (const SensorShown& sensor : sensors)
    if (sensors.size() > 1) names = std::max(names, small_label_width(sensor.name) + 0.5f * line);
  for (const HeatRow& row : rows)
    if (places.row >= kSmallText * line)
      ids = std::max(ids, small_label_width(std::to_string(row.key.id)) + 0.6f * line);
  return {names + ids + (ids > 0 ? 0.0f : 6.0f), ids};
}

void draw_heat_scale(const WindowUi& ui, const PressureRange& range, const ReadingUnit& unit) {
  constexpr int kBands = 32;
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), width = 7 * line, height = 0.6f * line;
  const std::string lo = fmt::format("{:.3g}", unit.scale * range.lo),
                    hi = fmt::format("{:.3g} {}", unit.scale * range.hi, unit.text);
  const float all = small_label_width(lo) + width + small_label_width(hi) + line;
  if (ImGui::GetContentRegionAvail().x < all) return ImGui::NewLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float text_y = at.y + 0.5f * (ImGui::GetFrameHeight() - kSmallText * line);
  const float x = at.x + small_label_width(lo) + 0.4f * line, y = at.y + 0.5f * (ImGui::GetFrameHeight() - height);
  small_label({at.x, text_y}, to_u32(colors.dim), lo);
  for (int i = 0; i < kBands; ++i) {
    const double middle = range.lo + (range.hi - range.lo) * (i + 0.5) / kBands;
    ImGui::GetWindowDrawList()->AddRectFilled({x + width * static_cast<float>(i) / kBands, y},
                                              {x + width * static_cast<float>(i + 1) / kBands, y + height},
                                              pressure_color(range, middle));
  }
  small_label({x + width + 0.4f * line, text_y}, to_u32(colors.dim), hi);
  ImGui::Dummy(ImVec2(all, ImGui::GetFrameHeight()));
}

std::size_t draw_heat_cells(const HeatFrame& frame, float y0, float y1) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto top = [&](std::size_t row) { return frame.origin.y + frame.places.tops[row]; };
  for (std::size_t r = 0; r < frame.rows.size();) {  // the lowest colour behind each sensor
    const std::size_t first = r;
    while (r < frame.rows.size() && frame.rows[r].sensor == frame.rows[first].sensor) ++r;
    const PressureRange& range = frame.ranges[frame.rows[first].sensor];
    list.AddRectFilled({frame.origin.x, top(first)}, {frame.origin.x + frame.width, top(r - 1) + frame.places.row},
                       pressure_color(range, range.lo));
  }
  std::vector<std::array<ImU32, kHeatLevels + 1>> colors(frame.sensors.size());
  for (std::size_t s = 0; s < colors.size(); ++s)
    for (int level = 0; level <= kHeatLevels; ++level)
      colors[s][static_cast<std::size_t>(level)] =
          pressure_color(frame.ranges[s],
                         frame.ranges[s].lo + (frame.ranges[s].hi - frame.ranges[s].lo) * (level - 0.5) / kHeatLevels);
  const std::vector<HeatRun> runs = heat_runs(frame.lanes, frame.rows, frame.cells, frame.ranges);
  for (const HeatRun& run : runs) {
    if (top(run.row) > y1 || top(run.row) + frame.places.row < y0) continue;
    list.AddRectFilled({frame.x(run.first), top(run.row)}, {frame.x(run.last), top(run.row) + frame.places.row},
                       colors[frame.rows[run.row].sensor][static_cast<std::size_t>(run.level)]);
  }
  return runs.size();
}

void draw_heat_labels(WindowUi& ui, const Selection& selection, const HeatFrame& frame, float left, float ids) {
  const Palette& colors = palette(ui.dark);
  const float line = kSmallText * ImGui::GetFontSize();
  const ImVec4 visible = ImGui::GetCurrentWindowRead()->ClipRect.ToVec4();
  for (std::size_t r = 0; r < frame.rows.size(); ++r) {
    const HeatRow& row = frame.rows[r];
    const float top = frame.origin.y + frame.places.tops[r], middle = top + 0.5f * frame.places.row;
    if (top + frame.places.row < visible.y || top > visible.w) continue;
    const bool begins = r == 0 || frame.rows[r - 1].sensor != row.sensor;
    if (begins && frame.sensors.size() > 1)
      small_label({left, std::round(top)}, to_u32(row.key.sensor == selection.sensor ? colors.accent : colors.text),
                  frame.sensors[row.sensor].name);
    if (ids > 0)
      small_label({frame.origin.x - ids, std::round(middle - 0.5f * line)}, to_u32(colors.dim),
                  std::to_string(row.key.id));
    if (is_selected(selection, row.key)) {
      const float half = std::max(1.5f, 0.5f * frame.places.row);
      ImGui::GetWindowDrawList()->AddRectFilled({frame.origin.x - 4, middle - half},
                                                {frame.origin.x - 1, middle + half}, to_u32(colors.accent));
      ImGui::GetWindowDrawList()->AddRect(
          {frame.origin.x, top - 1}, {frame.origin.x + frame.width, top + frame.places.row + 1}, to_u32(colors.accent));
    }
    ui.widgets.note(kHeatMap.title, "Heat " + row.label,
                    {frame.origin.x, top, frame.origin.x + frame.width, top + frame.places.row});
  }
}

void draw_heat_axis(const WindowUi& ui, const HeatFrame& frame, float y) {
  const Palette& colors = palette(ui.dark);
  const double first = frame.lanes.steps.front().time, last = frame.lanes.steps.back().time;
  constexpr int kTicks = 6;
  for (int i = 0; i <= kTicks; ++i) {
    const double time = first + (last - first) * i / kTicks;
    const float x = frame.x_of_step(nearest_row(frame.lanes, &StepMark::time, time));
    const std::string text = fmt::format("{:.3g}{}", time, i == kTicks ? " s" : "");
    const float width = small_label_width(text);
    const float at = std::clamp(x - 0.5f * width, frame.origin.x, frame.origin.x + frame.width - width);
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x, y + 3}, to_u32(colors.dim));
    small_label({std::round(at), y + 3}, to_u32(colors.dim), text);
    if (last <= first) break;
  }
}

void draw_heat_cursor(const WindowUi& ui, const HeatFrame& frame, std::uint64_t step, float y0, float y1) {
  const float x = std::round(frame.x_of_step(frame.lanes.row_of(step)));
  ImGui::GetWindowDrawList()->AddLine({x, y0}, {x, y1}, to_u32(palette(ui.dark).path), 1.5f);
}

}  // namespace taxel::ui
