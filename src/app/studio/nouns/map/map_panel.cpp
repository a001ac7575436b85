#include "app/studio/nouns/map/map_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {

MapFit fit_map(const FlatMap& map, const ImVec2& origin, const ImVec2& size, float line) {
  constexpr float kMargins = 0.6f, kMaxRadius = 2.2f;  // in heights of text
  constexpr float kMinRadius = 1.5f;                   // [pixels]
  dvec2 lo(std::numeric_limits<double>::infinity()), hi(-lo);
  for (const dvec2& p : map.places) lo = glm::min(lo, p), hi = glm::max(hi, p);
  MapFit fit;
  fit.middle = {origin.x + 0.5f * size.x, origin.y + 0.5f * size.y};
  fit.center = 0.5 * (lo + hi);
  const dvec2 extent = hi - lo + dvec2(2 * kDiscRadiusFraction * map.apart);  // with the discs at the rim
  const dvec2 room(static_cast<double>(size.x - kMargins * line), static_cast<double>(size.y - kMargins * line));
  fit.scale = std::min(extent.x > 0 ? room.x / extent.x : room.x, extent.y > 0 ? room.y / extent.y : room.y);
  const double radius = map.apart > 0 ? kDiscRadiusFraction * map.apart * fit.scale : 0.5 * std::min(room.x, room.y);
  fit.radius = std::clamp(static_cast<float>(radius), kMinRadius, kMaxRadius * line);
  return fit;
}

std::vector<MapCell> map_cells(std::span<const FlatMap* const> maps, const ImVec2& origin, const ImVec2& size,
                               float line, float name, float widest) {
  constexpr double kSmaller = 0.5;  // part of the scale that is left for whole names
  std::vector<MapCell> best, named;
  double best_scale = -std::numeric_limits<double>::infinity(), named_scale = best_scale;
  for (std::size_t columns = 1; columns <= maps.size(); ++columns) {
    const std::size_t rows = (maps.size() + columns - 1) / columns;
    const ImVec2 step(size.x / static_cast<float>(columns), size.y / static_cast<float>(rows));
    std::vector<MapCell> cells;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < maps.size(); ++i) {
      const ImVec2 at(origin.x + static_cast<float>(i % columns) * step.x,
                      origin.y + static_cast<float>(i / columns) * step.y);
      cells.push_back({at, {step.x, step.y - name}});
      smallest = std::min(smallest, fit_map(*maps[i], at, cells.back().size, line).scale);
    }
    if (smallest > named_scale && step.x >= widest) named_scale = smallest, named = cells;
    if (smallest > best_scale) best_scale = smallest, best = std::move(cells);
  }
  return named_scale > 0 && named_scale >= kSmaller * best_scale ? named : best;
}

namespace {

constexpr float kRimFrom = 6.0f;     // smallest radius with a rim [pixels]; on smaller discs a rim hides the colour
constexpr float kNameHeight = 1.2f;  // room for the name of a sensor [heights of text]
constexpr float kAroundName = 0.4f;  // gap between two names [heights of text]

void draw_text(ImVec2 center, ImU32 color, const std::string& text) {
  const float size = kSmallText * ImGui::GetFontSize();
  const float width = kSmallText * ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size,
                                      {std::round(center.x - 0.5f * width), std::round(center.y - 0.5f * size)}, color,
                                      text.c_str());
}

void draw_disc(WindowUi& ui, const Selection& selection, const MapDisc& disc, bool read, const PressureRange& range) {
  const Palette& colors = palette(ui.dark);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at(static_cast<float>(disc.x), static_cast<float>(disc.y));
  const auto radius = static_cast<float>(disc.radius);
  const bool selected = is_selected(selection, {disc.sensor, disc.taxel_id});
  list.AddCircleFilled(at, radius, read ? pressure_color(range, disc.value) : to_u32(colors.field));
  if (selected || radius > kRimFrom)
    list.AddCircle(at, radius, to_u32(selected ? colors.accent : colors.line), 0, (selected ? 3.0f : 1.0f));
  const std::string id = std::to_string(disc.taxel_id);
  if (kSmallText * ImGui::CalcTextSize(id.c_str()).x > 1.8f * radius) return;
  const glm::vec3 fill = range.color(disc.value);
  draw_text(at, to_u32(read ? text_on({fill.x, fill.y, fill.z, 1}) : colors.text), id);
}

/// One map of the panel: that of a sensor of the simulation, or that of the document in LAYOUT.
struct ShownMap {
  int sensor = 0;    ///< index of the sensor in the simulation
  std::string name;  ///< name of the sensor; empty if there is only one
  SensorModelPtr model;
  const std::vector<double>* readings = nullptr;  ///< readings of the taxels, or null if nothing is read
  PressureRange range;
};

std::vector<ShownMap> shown_maps(const Viewer& viewer, const Shown& shown) {
  std::vector<ShownMap> maps;
  const PressureRange range = reading_range(viewer, shown);
  const std::vector<SensorShown> sensors = sensors_shown(shown.run);
  if (shows_run(viewer.mode) && !sensors.empty()) {
    for (const SensorShown& sensor : sensors)
      maps.push_back({sensor.index, sensors.size() > 1 ? sensor.name : "", sensor.model, &sensor.step->readings,
                      range_of(sensors, sensor, shown.run, viewer.selection, range)});
    return maps;
  }
  const SensorModelPtr model = shown.model(viewer);
  const SensorStep* state = shown.state(viewer);
  if (model && !model->layout.taxels.empty())
    maps.push_back({viewer.selection.sensor, "", model, state != nullptr ? &state->readings : nullptr, range});
  return maps;
}

std::string hover_text(const ShownMap& map, const Taxel& taxel, const MapDisc& disc, bool read) {
  std::string text = fmt::format("Taxel {}{}{}{}{}", map.name, map.name.empty() ? "" : " ", taxel.id,
                                 taxel.name.empty() ? "" : ", ", taxel.name);
  return read ? text + "\n" + in_unit(disc.value, shown_unit(map.model->layout.readout.aggregate)) : text;
}

/// Draws the map of one sensor. Returns the id of the taxel under the pointer.
std::optional<int> draw_map(WindowUi& ui, const Selection& selection, MapState& state, const ShownMap& map,
                            const FlatMap& flat, const MapCell& cell, bool hovered) {
  const std::vector<Taxel>& taxels = map.model->layout.taxels;
  const bool read = map.readings != nullptr && map.readings->size() == taxels.size();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const MapFit place = fit_map(flat, cell.origin, cell.size, ImGui::GetFontSize());
  std::optional<std::size_t> under;
  const std::size_t first = state.discs.size();
  for (std::size_t k = 0; k < taxels.size(); ++k) {
    const ImVec2 at = place.at(flat.places[k]);
    state.discs.push_back({map.sensor, taxels[k].id, read ? (*map.readings)[k] : 0.0, static_cast<double>(at.x),
                           static_cast<double>(at.y), static_cast<double>(place.radius)});
    draw_disc(ui, selection, state.discs.back(), read, map.range);
    const float r = place.radius;
    ui.widgets.note(kTaxelMap.title, fmt::format("Disc {}{}{}", map.name, map.name.empty() ? "" : " ", taxels[k].id),
                    {at.x - r, at.y - r, at.x + r, at.y + r});
    if (hovered && std::hypot(mouse.x - at.x, mouse.y - at.y) <= place.radius) under = k;
  }
  if (!map.name.empty())
    draw_text(
        {cell.origin.x + 0.5f * cell.size.x, cell.origin.y + cell.size.y + 0.5f * kNameHeight * ImGui::GetFontSize()},
        to_u32(map.sensor == selection.sensor ? palette(ui.dark).accent : palette(ui.dark).text),
        shortened(map.name, cell.size.x - kAroundName * ImGui::GetFontSize()));
  if (!under) return std::nullopt;
  ImGui::SetTooltip("%s", hover_text(map, taxels[*under], state.discs[first + *under], read).c_str());
  return taxels[*under].id;
}

void draw_maps(WindowUi& ui, Viewer& viewer, MapState& state, const std::vector<ShownMap>& maps) {
  std::vector<const FlatMap*> flat;
  for (const SensorMap& map : state.maps) flat.push_back(&map.map);
  const auto of_selected = std::find_if(maps.begin(), maps.end(),
                                        [&](const ShownMap& map) { return map.sensor == viewer.selection.sensor; });
  const std::size_t chosen = of_selected == maps.end() ? 0 : static_cast<std::size_t>(of_selected - maps.begin());
  const ShownMap& map = maps[chosen];
  state.unrolled = flat[chosen]->unrolled;
  const bool read = map.readings != nullptr && map.readings->size() == map.model->layout.taxels.size();
  caption((std::string(read ? shown_unit(map.model->layout.readout.aggregate).text : "Taxels") +
           (state.unrolled ? ", unrolled: the pad in the middle, distal up" : ", seen along their mean normal"))
              .c_str());
  const ImVec2 origin = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (!(size.x > 8 && size.y > 8)) return;
  ImGui::InvisibleButton("##map", size);
  ui.widgets.note_item("Map");
  const bool hovered = ImGui::IsItemHovered(), pressed = ImGui::IsItemClicked();
  const float line = ImGui::GetFontSize();
  float widest = 0;
  for (const ShownMap& each : maps) widest = std::max(widest, small_width(each.name) + kAroundName * line);
  const std::vector<MapCell> cells =
      map_cells(flat, origin, size, line, maps.size() > 1 ? kNameHeight * line : 0.0f, widest);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const std::optional<int> under = draw_map(ui, viewer.selection, state, maps[i], *flat[i], cells[i], hovered);
    if (under && pressed) click_taxel_of(viewer.selection, {maps[i].sensor, *under}, ImGui::GetIO().KeyShift);
  }
}

/// Unrolls the layouts that changed.
void update_maps(std::vector<SensorMap>& sensor_maps, const std::vector<ShownMap>& maps) {
  sensor_maps.resize(maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const SensorModelPtr& model = maps[i].model;
    if (sensor_maps[i].model != model)
      sensor_maps[i] = {model, flat_map(model->layout, model->skin->mesh().centroid())};
  }
}

void draw_map_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, MapState& map, bool& open) {
  if (begin_panel(ui, kTaxelMap.title, &open)) {
    const std::vector<ShownMap> maps = shown_maps(viewer, shown);
    if (maps.empty()) {
      ImGui::TextDisabled("There are no taxels.");
    } else {
      update_maps(map.maps, maps);
      draw_maps(ui, viewer, map, maps);
    }
  }
  ImGui::End();
}

}  // namespace

constinit const Feature kTaxelMap{
    .title = "Taxel map",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .key = "panel_map",
    .label = "Taxel map",
    .of_readings = true,
    .draw =
        [](App& app) {
          draw_map_panel(*app.ui, *app.viewer, *app.shown, app.get<MapState>(), app.get<PanelsShown>()[kTaxelMap]);
        },
    .guide = "Look at one step",
    .begin_frame = [](App& app) { app.get<MapState>().discs.clear(); },
    .dump = dump_taxel_map,
};

}  // namespace taxel::ui
