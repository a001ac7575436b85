// The heat map: its rows, its cells of taxel and time with their colours, and the panel that draws them.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/heat/heat_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/sensor/readout/reading.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {
namespace {

/// Returns the largest recorded reading of each taxel of all sensors.
std::vector<double> largest_recorded(const HistoryLanes& lanes) {
  std::vector<double> largest(lanes.reading_count, 0.0);
  for (std::size_t row = 0; row < lanes.rows(); ++row) {
    const std::span<const double> readings = lanes.readings_of(row);
    for (std::size_t k = 0; k < readings.size(); ++k) largest[k] = std::max(largest[k], readings[k]);
  }
  return largest;
}

}  // namespace

std::vector<HeatRow> heat_rows(const HistoryLanes& lanes, const std::vector<SensorShown>& sensors,
                               const Selection& selection, bool responding_only) {
  std::vector<HeatRow> rows;
  const std::vector<double> largest = responding_only ? largest_recorded(lanes) : std::vector<double>{};
  const auto largest_of = [&](const ReadingUnit& unit) {
    double most = 0;
    for (const SensorShown& sensor : sensors)
      for (std::size_t k = 0; same_unit(sensor.unit, unit) && k < sensor.taxels().size(); ++k)
        if (sensor.first + k < largest.size()) most = std::max(most, largest[sensor.first + k]);
    return most;
  };
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const SensorShown& sensor = sensors[s];
    const double least = responding_only ? kTaxelResponds * largest_of(sensor.unit) : 0.0;
    for (std::size_t k = 0; k < sensor.taxels().size() && sensor.first + k < lanes.reading_count; ++k) {
      const TaxelKey key{sensor.index, sensor.taxels()[k].id};
      if (responding_only && !(largest[sensor.first + k] > least) && !is_selected(selection, key)) continue;
      rows.push_back({key, taxel_label(sensors, sensor, key.id), s, sensor.first + k});
    }
  }
  return rows;
}

std::optional<std::size_t> HeatPlaces::row_at(float y) const {
  const auto above = std::upper_bound(tops.begin(), tops.end(), y);
  if (above == tops.begin()) return std::nullopt;
  const auto at = static_cast<std::size_t>(above - tops.begin()) - 1;
  return y < tops[at] + heights[at] ? std::optional(at) : std::nullopt;
}

HeatPlaces place_rows(const std::vector<HeatRow>& rows, float height, float least, float most, float gap, float name) {
  HeatPlaces places;
  if (rows.empty()) return places;
  const std::size_t groups = rows.back().sensor - rows.front().sensor + 1;
  const float gaps = gap * static_cast<float>(groups - 1);
  places.row = std::clamp((height - gaps) / static_cast<float>(rows.size()), least, most);
  float y = 0;
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin;
    while (end < rows.size() && rows[end].sensor == rows[begin].sensor) ++end;
    const float row = std::max(places.row, name / static_cast<float>(end - begin));
    if (begin > 0) y += gap;
    for (; begin < end; ++begin) {
      places.tops.push_back(y);
      places.heights.push_back(row);
      y += row;
    }
  }
  places.height = y;
  return places;
}

HeatCells heat_cells(const HistoryLanes& lanes, const std::vector<HeatRow>& rows, std::size_t columns) {
  HeatCells cells;
  const std::size_t steps = lanes.rows();
  cells.columns = std::clamp<std::size_t>(columns, 1, steps);
  cells.steps.resize(rows.size() * cells.columns);
  for (std::size_t column = 0; column < cells.columns; ++column) {
    const std::size_t first = column * steps / cells.columns, last = (column + 1) * steps / cells.columns;
    for (std::size_t r = 0; r < rows.size(); ++r)
      cells.steps[r * cells.columns + column] = static_cast<std::uint32_t>(first);
    for (std::size_t step = first + 1; step < last; ++step) {
      const std::span<const double> readings = lanes.readings_of(step);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        std::uint32_t& largest = cells.steps[r * cells.columns + column];
        if (readings[rows[r].reading] > lanes.readings_of(largest)[rows[r].reading])
          largest = static_cast<std::uint32_t>(step);
      }
    }
  }
  return cells;
}

int heat_level(const PressureRange& range, double reading) {
  if (!(range.hi > range.lo) || !(reading > range.lo)) return 0;
  const double part = std::min(1.0, (reading - range.lo) / (range.hi - range.lo));
  return std::max(1, static_cast<int>(std::ceil(kHeatLevels * part)));
}

std::vector<HeatRun> heat_runs(const HistoryLanes& lanes, const std::vector<HeatRow>& rows, const HeatCells& cells,
                               const std::vector<PressureRange>& ranges) {
  std::vector<HeatRun> runs;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    HeatRun run{r, 0, 0, 0};
    for (std::size_t column = 0; column < cells.columns; ++column) {
      const double reading = lanes.readings_of(cells.step(r, column))[rows[r].reading];
      const int level = heat_level(ranges[rows[r].sensor], reading);
      if (level != run.level) {
        if (run.level > 0) runs.push_back(run);
        run.first = column;
        run.level = level;
      }
      run.last = column + 1;
    }
    if (run.level > 0) runs.push_back(run);
  }
  return runs;
}

namespace {

/// The map in this frame. Places are pixels of the window.
struct HeatFrame {
  const HistoryLanes& lanes;
  const std::vector<SensorShown>& sensors;
  const std::vector<PressureRange>& ranges;  ///< parallel to `sensors`
  const std::vector<HeatRow>& rows;
  const HeatPlaces& places;
  HeatCells cells;
  ImVec2 origin;    ///< upper left corner of the first cell
  float width = 0;  ///< width of all cells

  [[nodiscard]] float x(std::size_t column) const {
    return origin.x + width * static_cast<float>(column) / static_cast<float>(cells.columns);
  }
  [[nodiscard]] float x_of_step(std::size_t row) const {
    return origin.x + width * (static_cast<float>(row) + 0.5f) / static_cast<float>(lanes.rows());
  }
};

void small_label(ImVec2 pos, ImU32 color, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), kSmallText * ImGui::GetFontSize(), pos, color, text.c_str());
}

constexpr float kMaxName = 10;  // width of the names of sensors [heights of text]

/// Returns the width of the names left of the cells, and of the ids in it. Ids need rows as high as text.
std::array<float, 2> heat_label_widths(const std::vector<SensorShown>& sensors, const std::vector<HeatRow>& rows,
                                       const HeatPlaces& places) {
  const float line = ImGui::GetFontSize();
  float names = 0, ids = 0;
  for (const SensorShown& sensor : sensors)
    if (sensors.size() > 1) names = std::max(names, std::min(kMaxName * line, small_width(sensor.name)) + 0.5f * line);
  for (const HeatRow& row : rows)
    if (places.row >= kSmallText * line) ids = std::max(ids, small_width(std::to_string(row.key.id)) + 0.6f * line);
  return {names + ids + (ids > 0 ? 0.0f : 6.0f), ids};
}

/// Draws the cells between the heights y0 and y1. Returns the number of rectangles of the whole map.
std::size_t draw_heat_cells(const HeatFrame& frame, float y0, float y1) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto top = [&](std::size_t row) { return frame.origin.y + frame.places.tops[row]; };
  for (std::size_t r = 0; r < frame.rows.size();) {  // the lowest colour behind each sensor
    const std::size_t first = r;
    while (r < frame.rows.size() && frame.rows[r].sensor == frame.rows[first].sensor) ++r;
    const PressureRange& range = frame.ranges[frame.rows[first].sensor];
    list.AddRectFilled({frame.origin.x, top(first)},
                       {frame.origin.x + frame.width, top(r - 1) + frame.places.heights[r - 1]},
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
    if (top(run.row) > y1 || top(run.row) + frame.places.heights[run.row] < y0) continue;
    list.AddRectFilled({frame.x(run.first), top(run.row)},
                       {frame.x(run.last), top(run.row) + frame.places.heights[run.row]},
                       colors[frame.rows[run.row].sensor][static_cast<std::size_t>(run.level)]);
  }
  return runs.size();
}

/// Draws the names of the sensors from `left`, and ids if their width is not 0. Marks selected taxels.
void draw_heat_labels(WindowUi& ui, const Selection& selection, const HeatFrame& frame, float left, float ids) {
  const Palette& colors = palette(ui.dark);
  const float line = kSmallText * ImGui::GetFontSize();
  const ImVec4 visible = ImGui::GetCurrentWindowRead()->ClipRect.ToVec4();
  for (std::size_t r = 0; r < frame.rows.size(); ++r) {
    const HeatRow& row = frame.rows[r];
    const float top = frame.origin.y + frame.places.tops[r], high = frame.places.heights[r], middle = top + 0.5f * high;
    if (top + high < visible.y || top > visible.w) continue;
    const bool begins = r == 0 || frame.rows[r - 1].sensor != row.sensor;
    if (begins && frame.sensors.size() > 1)
      small_label({left, std::round(top)}, to_u32(row.key.sensor == selection.sensor ? colors.accent : colors.text),
                  shortened(frame.sensors[row.sensor].name, kMaxName * ImGui::GetFontSize()));
    if (ids > 0)
      small_label({frame.origin.x - ids, std::round(middle - 0.5f * line)}, to_u32(colors.dim),
                  std::to_string(row.key.id));
    if (is_selected(selection, row.key)) {
      const float half = std::max(1.5f, 0.5f * high);
      ImGui::GetWindowDrawList()->AddRectFilled({frame.origin.x - 4, middle - half},
                                                {frame.origin.x - 1, middle + half}, to_u32(colors.accent));
      ImGui::GetWindowDrawList()->AddRect({frame.origin.x, top - 1}, {frame.origin.x + frame.width, top + high + 1},
                                          to_u32(colors.accent));
    }
    ui.widgets.note(kHeatMap.title, "Heat " + row.label,
                    {frame.origin.x, top, frame.origin.x + frame.width, top + high});
  }
}

/// Draws the axis of time below the cells.
void draw_heat_axis(const WindowUi& ui, const HeatFrame& frame, float y) {
  const Palette& colors = palette(ui.dark);
  const double first = frame.lanes.steps.front().time, last = frame.lanes.steps.back().time;
  constexpr int kTicks = 6;
  for (int i = 0; i <= kTicks; ++i) {
    const double time = first + (last - first) * i / kTicks;
    const float x = frame.x_of_step(nearest_row(frame.lanes, &StepMark::time, time));
    const std::string text = fmt::format("{:.3g}{}", time, i == kTicks ? " s" : "");
    const float width = small_width(text);
    const float at = std::clamp(x - 0.5f * width, frame.origin.x, frame.origin.x + frame.width - width);
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x, y + 3}, to_u32(colors.dim));
    small_label({std::round(at), y + 3}, to_u32(colors.dim), text);
    if (last <= first) break;
  }
}

/// Draws a line at a recorded step.
void draw_heat_cursor(const WindowUi& ui, const HeatFrame& frame, std::uint64_t step, float y0, float y1) {
  const float x = std::round(frame.x_of_step(frame.lanes.row_of(step)));
  ImGui::GetWindowDrawList()->AddLine({x, y0}, {x, y1}, to_u32(palette(ui.dark).path), 1.5f);
}

constexpr float kHeatLeastRow = 2, kHeatGap = 4;  // height of a row and gap between sensors, at scale 1 [pixels]
constexpr float kHeatColumnWidth = 2;             // width of a column [pixels]

std::optional<HeatHover> cell_at(const HeatFrame& frame, ImVec2 mouse) {
  const std::optional<std::size_t> row = frame.places.row_at(mouse.y - frame.origin.y);
  const float part = (mouse.x - frame.origin.x) / std::max(1.0f, frame.width);
  if (!row || !(part >= 0 && part < 1)) return std::nullopt;
  const auto column =
      std::min(frame.cells.columns - 1, static_cast<std::size_t>(part * static_cast<float>(frame.cells.columns)));
  const std::size_t step = frame.cells.step(*row, column);
  const StepMark& mark = frame.lanes.steps[step];
  return HeatHover{frame.rows[*row].key, frame.rows[*row].label, mark.step, mark.time,
                   frame.lanes.readings_of(step)[frame.rows[*row].reading]};
}

/// Displays the recorded step of the cell under a click or a drag. A click on the names selects the taxel.
void handle_pointer(WindowUi& ui, Viewer& viewer, const RunView& run, const HeatFrame& frame, HeatShown& shown) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsItemHovered()) shown.hover = cell_at(frame, mouse);
  if (const auto& hover = shown.hover) {
    const std::size_t sensor = frame.rows[*frame.places.row_at(mouse.y - frame.origin.y)].sensor;
    ImGui::SetTooltip("Taxel %s\n%.4g s\n%s", hover->label.c_str(), hover->time,
                      in_unit(hover->reading, frame.sensors[sensor].unit).c_str());
  }
  if (ImGui::IsItemClicked() && mouse.x < frame.origin.x)
    if (const auto row = frame.places.row_at(mouse.y - frame.origin.y))
      click_taxel_of(viewer.selection, frame.rows[*row].key, ImGui::GetIO().KeyShift);
  const bool began_in_cells = ImGui::GetIO().MouseClickedPos[0].x >= frame.origin.x;
  if (shown.hover && ImGui::IsItemActive() && began_in_cells)
    if (shown.hover->step != run.frame->step || run.playing) ui.post(ScrubTo{shown.hover->step});
}

void draw_heat(WindowUi& ui, Viewer& viewer, const RunView& run, const std::vector<SensorShown>& sensors,
               const std::vector<PressureRange>& ranges, HeatShown& shown) {
  const HistoryLanes& lanes = *run.frame->history.lanes;
  const float line = ImGui::GetFontSize(), axis = 1.3f * line, scale = static_cast<float>(ui.pixel_scale);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float visible = std::max(line, room.y - axis);
  const float name = sensors.size() > 1 ? kSmallText * line : 0.0f;
  shown.places = place_rows(shown.rows, visible, kHeatLeastRow * scale, 1.4f * line, kHeatGap * scale, name);
  const bool scrolls = shown.places.height > visible + 0.5f;
  const auto [labels, ids] = heat_label_widths(sensors, shown.rows, shown.places);
  const float bar = scrolls ? ImGui::GetStyle().ScrollbarSize : 0.0f;
  HeatFrame frame{lanes, sensors, ranges, shown.rows, shown.places, {}, {}, std::max(1.0f, room.x - labels - bar)};
  frame.cells = heat_cells(lanes, shown.rows, static_cast<std::size_t>(frame.width / (kHeatColumnWidth * scale)) + 1);
  shown.columns = frame.cells.columns;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  frame.origin = {corner.x + labels, corner.y};
  draw_heat_axis(ui, frame, corner.y + std::min(visible, shown.places.height));
  if (ImGui::BeginChild("##heat", ImVec2(0, visible))) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    frame.origin = {at.x + labels, at.y};
    ImGui::InvisibleButton("##cells", ImVec2(labels + frame.width, std::max(1.0f, shown.places.height)));
    const float bottom = corner.y + std::min(visible, shown.places.height);
    shown.cells = {frame.origin.x, corner.y, frame.origin.x + frame.width, bottom};
    ui.widgets.note(kHeatMap.title, "Heat cells", shown.cells);
    handle_pointer(ui, viewer, run, frame, shown);
    shown.runs = draw_heat_cells(frame, corner.y, bottom);
    draw_heat_labels(ui, viewer.selection, frame, at.x, ids);
    draw_heat_cursor(ui, frame, run.frame->step, corner.y, bottom);
  }
  ImGui::EndChild();
}

void draw_heat_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, HeatState& heat, bool& open) {
  heat.shown = {};
  if (begin_panel(ui, kHeatMap.title, &open)) {
    const std::vector<SensorShown> sensors = sensors_shown(shown.run);
    const HistoryLanes* lanes = shown.run.frame ? shown.run.frame->history.lanes.get() : nullptr;
    if (sensors.empty() || lanes == nullptr || lanes->rows() == 0) {
      ImGui::TextDisabled("Run the simulation: the readings of recorded steps are drawn here.");
    } else {
      ImGui::PushFont(nullptr, kTextHeight * kSmallText);
      ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(6, 2));
      checkbox(ui, "Responding only", &heat.responding_only);
      tooltip(fmt::format("Only taxels whose largest reading is above {:g} % of the largest of all, and selected ones",
                          100 * kTaxelResponds));
      std::vector<PressureRange> ranges;
      const PressureRange selected = reading_range(viewer, shown);
      for (const SensorShown& sensor : sensors)
        ranges.push_back(range_of(sensors, sensor, shown.run, viewer.selection, selected));
      ImGui::SameLine(0, 14);
      draw_color_scale(ui, selected, selected_unit(sensors, viewer.selection), ImGui::GetFrameHeight());
      ImGui::PopStyleVar();
      heat.shown.rows = heat_rows(*lanes, sensors, viewer.selection, heat.responding_only);
      heat.shown.first_step = lanes->steps.front().step;
      heat.shown.last_step = lanes->steps.back().step;
      if (heat.shown.rows.empty()) {
        ImGui::TextDisabled("No taxel responds yet.");
      } else {
        draw_heat(ui, viewer, shown.run, sensors, ranges, heat.shown);
      }
      ImGui::PopFont();
    }
  }
  ImGui::End();
}

std::vector<PanelPart> heat_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.frame != nullptr ? nullptr : "Nothing is simulated";
  };
  return {{"Responding only", "", "Leave out the taxels that the contact does not reach", kSimulate, kWhyNot}};
}

}  // namespace

constinit const Feature kHeatMap{
    .title = "Heat map",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_heat",
    .label = "Heat map",
    .context = kSimulate,
    .of_readings = true,
    .draw =
        [](App& app) {
          draw_heat_panel(*app.ui, *app.viewer, *app.shown, app.get<HeatState>(), app.get<PanelsShown>()[kHeatMap]);
        },
    .parts = heat_parts,
    .guide = "Look at one step",
    .begin_frame = [](App& app) { app.get<HeatState>().shown = {}; },
    .dump = dump_heat_map,
};

}  // namespace taxel::ui
