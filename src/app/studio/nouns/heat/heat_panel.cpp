#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/reading_range.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/heat/heat.h"
#include "app/studio/nouns/heat/heat_drawing.h"
#include "app/studio/nouns/heat/heat_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/sensor/readout/reading.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

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
  shown.places = place_rows(shown.rows, visible, kHeatLeastRow * scale, 1.4f * line, kHeatGap * scale);
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
      draw_heat_scale(ui, selected, selected_unit(sensors, viewer.selection));
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

}  // namespace

constinit const Feature kHeatMap{
    .title = "Heat map",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_heat",
    .label = "Heat map panel",
    .context = kSimulate,
    .of_readings = true,
    .draw =
        [](App& app) {
          draw_heat_panel(*app.ui, *app.viewer, *app.shown, app.get<HeatState>(), app.get<PanelsShown>()[kHeatMap]);
        },
    .begin_frame = [](App& app) { app.get<HeatState>().shown = {}; },
    .dump = dump_heat_map,
};

}  // namespace taxel::ui
